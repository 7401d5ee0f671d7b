"""Special functions, layer factors and kernels, conversion of series."""

from values import EPS, Value, floats, relative, rows

TARGET = 1e-13


def absolute(file, row, quantity, value, reference, scale, condition=1.0):
    return Value("special", file, row, quantity, float(value), reference, scale, TARGET, 4.0 * EPS * condition)


def one_argument(harness):
    tables = [
        ("dawson.csv", {"dawson": "dawson", "argument_minus_dawson": "dawson_deficit", "slope": "dawson_slope"}),
        ("exponential_mean.csv",
         {"mean": "exponential_mean", "complement": "exponential_mean_complement", "decline": "exponential_mean_decline"}),
        ("cohesive_kernel.csv", {
            "opening": "opening_kernel", "opening_slope": "opening_kernel_slope", "intensity": "closing_intensity_kernel",
            "intensity_slope": "closing_intensity_kernel_slope", "work": "closing_work_kernel", "work_slope": "closing_work_kernel_slope"}),
        ("elliptic.csv", {"first_of_modulus": "elliptic_k_of_modulus", "second_of_modulus": "elliptic_e_of_modulus"}),
    ]
    for file, columns in tables:
        table = rows(file)
        for column, name in columns.items():
            found = harness.special(name, floats(" ".join(r["argument"] for r in table)))
            for row, value in zip(table, found):
                reference, argument = row[column], float(row["argument"])
                if column == "slope" and argument < 6.3:
                    # 1 - 2yD changes sign at 0.92: absolute.
                    yield absolute(file, row["argument"], column, value, reference, 1.0)
                elif column == "work_slope":
                    # Changes sign near 6.4: against its two parts.
                    parts = 2.0 * (abs(float(row["intensity_slope"])) + abs(float(row["opening_slope"])))
                    yield absolute(file, row["argument"], column, value, reference, parts)
                else:
                    yield relative("special", file, row["argument"], column, value, reference, TARGET)


def circle(harness):
    table = rows("clausen.csv")
    angles = floats(" ".join(r["angle"] for r in table))
    for column, name in (("clausen", "clausen"), ("dilogarithm_real", "dilogarithm_real"), ("log_sine", "log_sine")):
        for row, value in zip(table, harness.special(name, angles)):
            scale = {"clausen": abs(float(row["clausen"])), "dilogarithm_real": 1.0, "log_sine": 1.0 + abs(float(row["log_sine"]))}[column]
            yield absolute("clausen.csv", row["angle"], column, value, row[column], scale or 1.0)
    for row in rows("memory_clausen.csv"):
        ratio = float(row["ratio"])
        found = harness.memory_clausen([float(row["angle"])], ratio)
        scale = min(1.0, 1.0 / ratio)
        place = f"{row['angle']} {row['ratio']}"
        yield absolute("memory_clausen.csv", place, "integral", found[0][0], row["integral"], scale)
        yield relative("special", "memory_clausen.csv", place, "increment", found[1][0], row["increment"], TARGET)
        yield absolute("memory_clausen.csv", place, "memory_logarithm", found[2][0], row["memory_logarithm"],
                       scale + abs(float(row["memory_logarithm"])))


def elliptic(harness):
    for row in rows("indentation.csv"):
        if row["quantity"] == "elliptic_k":
            value = harness.special("elliptic_k_of_parameter", float(row["inputs"].split("=")[1]))[0]
            yield relative("special", "indentation.csv", row["inputs"], "elliptic_k", value, row["value"], TARGET)


def layers(harness):
    for row in rows("layer_factors.csv"):
        place = f"{row['backing']} {row['poisson_ratio']} {row['product']}"
        correction, factor = harness.layer_factors(row["backing"], float(row["poisson_ratio"]), float(row["product"]), 1.0)
        yield relative("special", "layer_factors.csv", place, "correction", correction[0], row["correction"], TARGET)
        yield relative("special", "layer_factors.csv", place, "compliance_factor", factor[0], row["compliance_factor"], TARGET)
    for row in rows("green.csv"):
        place = " ".join(row[k] for k in ("backing", "poisson_ratio", "thickness", "glassy_compliance", "compliances", "ratios", "position"))
        layer = None if row["backing"] == "half_plane" else (row["backing"], float(row["poisson_ratio"]), float(row["thickness"]))
        found = harness.sliding_green(float(row["glassy_compliance"]), floats(row["compliances"]), floats(row["ratios"]),
                                      float(row["position"]), layer_of=layer)
        for column, index in (("value", 0), ("antiderivative", 2)):
            yield absolute("green.csv", place, column, found[index][0], row[column], 1.0 + abs(float(row[column])))


def series(harness):
    """Each converted term against its own error bound's scale: a term that a last digit of the input moves is assessed by that."""
    table = rows("material_conversion.csv")
    for name in dict.fromkeys(row["material"] for row in table):
        own = [row for row in table if row["material"] == name]
        given = {}
        for row in own:
            if row["role"] == "input" and row["key"] not in ("kind", "units"):
                given.setdefault(row["key"], []).append(float(row["value"]))
        creep = any(row["key"] == "kind" and row["value"] == "creep" for row in own)
        if creep:
            material = harness.Material.from_creep(given["glassy_modulus"][0], given["creep_strength"], given["retardation_time"],
                                                   given.get("flow_viscosity", [None])[0])
            strength, time, terms = "relaxation_strength", "relaxation_time", material.relaxation_terms()
        else:
            material = harness.Material.from_relaxation(given["relaxed_modulus"][0], given["relaxation_strength"], given["relaxation_time"])
            strength, time, terms = "creep_strength", "retardation_time", material.creep_terms()
        bars = material.conversion_errors()
        for key, found, bar in ((strength, terms[0], bars[0]), (time, terms[1], bars[1])):
            # The file counts from the shortest time.
            outputs = [row for row in own if row["role"] == "output" and row["key"] == key]
            for index, (row, value, error) in enumerate(zip(outputs, found[::-1], bar[::-1])):
                yield relative("special", "material_conversion.csv", f"{name} {index}", key, value, row["value"], TARGET, max(1.0, error / EPS))
        for row in own:
            if row["role"] == "check":
                argument = float(row["argument"])
                if row["key"] in ("creep", "relaxation"):
                    value = getattr(material, row["key"])(argument)[0]
                else:
                    value = material.complex_modulus(argument)[row["key"] == "loss_modulus"][0]
                # Far down an exponential the rounding of t/rho is magnified by t/rho.
                condition = 1.0
                if row["key"] == "relaxation" and material.relaxed_modulus == 0.0:
                    condition += argument / max(material.relaxation_terms()[1])
                yield relative("special", "material_conversion.csv", f"{name} {row['argument']}", row["key"], value, row["value"], TARGET, 4.0 * condition)


def values(harness):
    for source in (one_argument, circle, elliptic, layers, series):
        yield from source(harness)
