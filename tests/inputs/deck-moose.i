[Mesh]
  type = GeneratedMesh
  dim = 3
[]
[Materials]
  [maxwell]
    type = GeneralizedMaxwellModel
    young_modulus = 10e9   # initial
    poisson_ratio = 0.2
    creep_modulus = '3e9 2.5e9'
    creep_viscosity = '1 10'
  []
  [strain]
    type = ComputeIncrementalSmallStrain
  []
[]
