[Materials]
  [kv]
    type = GeneralizedKelvinVoigtModel
    young_modulus = 10e9
  []
[]
