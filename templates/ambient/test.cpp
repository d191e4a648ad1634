TEST(@test@, IsDarkerFromBelow) {
  lumen::testing::Scene scene({64, 64});
  scene.add("ambient.@name@", "light", R"({"from_below": 0.5})");
  scene.surface("plate", lumen::testing::rectangle(), R"({"ambient": "light", "ambient_color": [1, 0.5, 0]})");
  const auto ambient = scene.layer("ambient");
  EXPECT_NEAR(ambient.at(32, 32, 0), 0.75f, 2e-3f);  // the plate faces the horizon: half of the way
  EXPECT_NEAR(ambient.at(32, 32, 1), 0.375f, 2e-3f);
}
