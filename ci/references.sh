#!/usr/bin/env bash
# Recomputes the reference data and compares it with what is committed: ci/references.sh PYTHON [--reduced]
# Reduced, each script takes the quick subset of its values; the elastic references know no subset and are left to the full run.
set -euo pipefail
cd "$(dirname "$0")/.."
python=$1; shift
scripts="steady_crack material_conversion isotropic_solid dawson exponential_mean elliptic cohesive_kernel memory_clausen periodic_green sliding_wave sliding_hysteresis sliding_held_loads delayed_fracture indentation indentation_shape sphere_annuli punch_rim edge_speed broad_laws tread_dma rolling_cylinders contact_rolling line_panels"
case " $* " in *" --reduced "*) ;; *) scripts="$scripts elastic" ;; esac
for script in $scripts; do
  echo "$script.py --check $*"
  "$python" "verification/references/$script.py" --check "$@"
done
