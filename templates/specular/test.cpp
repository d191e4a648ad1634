TEST(@test@, IsBrightestWhereTheLightIsMirrored) {
  lumen::testing::Scene scene({65, 65});
  scene.add("specular.@name@", "term", R"({"strength": 2})");
  scene.surface("plate", lumen::testing::rectangle(), R"({"specular": "term", "specular_color": [0.25, 0.125, 0]})");
  const auto specular = scene.layer("specular");
  EXPECT_NEAR(specular.at(32, 32, 0), 0.5f, 2e-3f);
  EXPECT_NEAR(specular.at(32, 32, 1), 0.25f, 2e-3f);
}
