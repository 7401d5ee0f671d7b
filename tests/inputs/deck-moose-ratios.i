[Materials]
  [./concrete]
    type = GeneralizedMaxwellModel
    creep_modulus = '3
                     2'
    creep_ratio = "0.25 0.1"
    creep_viscosity = '1 10'
    poisson_ratio = 0.2
    young_modulus = 10
  [../]
[]
