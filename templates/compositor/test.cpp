TEST(@test@, MultipliesThePicture) {
  lumen::testing::Scene scene({64, 64});
  scene.add("diffuse.lambert", "lambert");
  scene.surface("plate", lumen::testing::rectangle(), R"({"diffuse": "lambert", "ambient_color": [0, 0, 0], "diffuse_color": [1, 1, 1]})");
  scene.add("compositor.@name@", "tint", R"({"tint": [0.5, 0.25, 0]})");
  const auto picture = scene.picture();
  EXPECT_NEAR(picture.at(32, 32, 0), 0.5f, 2e-3f);
  EXPECT_NEAR(picture.at(32, 32, 1), 0.25f, 2e-3f);
  EXPECT_NEAR(picture.at(32, 32, 2), 0.0f, 2e-3f);
}
