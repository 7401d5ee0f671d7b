"""Roots of many functions at once: each between its own bracket, and each between two neighbouring poles."""

import math

import numpy as np

# Spacing of doubles at one.
EPS = 2.0 ** -52


def bracketed(value, low, high, at_low=None, at_high=None, iterations=120):
    """Roots between brackets, all at once: Chandrupatla's inverse quadratic steps, bisection where they are not safe (Adv. Eng. Softw. 28 (1997) 145)."""
    low, high = np.array(low, dtype=float), np.array(high, dtype=float)
    at_low = np.array(value(low) if at_low is None else at_low, dtype=float)
    at_high = np.array(value(high) if at_high is None else at_high, dtype=float)
    new, at_new, other, at_other = low, at_low, high, at_high
    with np.errstate(all="ignore"):
        part = np.full(len(low), 0.5)
        for _ in range(iterations):
            nearer = np.abs(at_other) < np.abs(at_new)
            root, left = np.where(nearer, other, new), np.where(nearer, at_other, at_new)
            least = 2.0 * EPS * np.abs(root) / np.abs(other - new)
            done = ~(least < 0.5) | (left == 0.0)
            if done.all():
                break
            trial = new + np.clip(part, least, 1.0 - least) * (other - new)
            trial = np.where(done, root, trial)
            found = value(trial)
            same = (found > 0.0) == (at_new > 0.0)
            last, at_last = np.where(same, new, other), np.where(same, at_new, at_other)
            other, at_other = np.where(same, other, new), np.where(same, at_other, at_new)
            new, at_new = trial, np.where(done, left, found)
            way, rise = (new - other) / (last - other), (at_new - at_other) / (at_last - at_other)
            smooth = (rise * rise < way) & ((1.0 - rise) ** 2 < 1.0 - way)
            inverse = at_new / (at_other - at_new) * at_last / (at_other - at_last) + (last - new) / (other - new) * at_new / (at_last - at_new) * at_other / (at_last - at_other)
            part = np.where(smooth, inverse, 0.5)
    return root


def poles_between(function, poles, sign, last):
    """Roots of a function that is monotone between neighbouring poles: for each the nearer pole and the signed distance from it, to full relative precision.

    `function(pole_index, distance)` for arrays; `sign` times it is positive just right of a pole and negative just left of the next one. With `last`, also
    one root beyond the last pole."""
    nearest, distances = [], []
    count = len(poles)
    for k in range(count - 1 + bool(last)):
        if k + 1 < count:
            half = 0.5 * (poles[k + 1] - poles[k])
            right = sign * function(k, half) > 0.0
        else:
            half, right = poles[k] + 1e-300, False
            while sign * function(k, half) > 0.0:
                half *= 2.0
        base, direction = (k + 1, -1.0) if right else (k, 1.0)
        low, high = math.log(half) - 650.0, math.log(half)
        low = max(low, -690.0)
        for _ in range(70):
            middle = 0.5 * (low + high)
            positive = sign * function(base, direction * math.exp(middle)) > 0.0
            # Towards the right-hand pole the function falls; seen from it, it rises with the distance.
            if positive == (direction > 0.0):
                low = middle
            else:
                high = middle
        nearest.append(base)
        distances.append(direction * math.exp(0.5 * (low + high)))
    return np.array(nearest, dtype=int), np.array(distances)
