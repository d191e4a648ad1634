TEST(@test@, GivesTheMaterialWhereItFacesTheLight) {
  lumen::testing::Scene scene({64, 64});
  scene.add("diffuse.@name@", "term");
  scene.surface("ball", lumen::testing::sphere(128), R"({"diffuse": "term", "diffuse_color": [1, 0.5, 0]})");
  const auto diffuse = scene.layer("diffuse");
  EXPECT_NEAR(diffuse.at(32, 32, 0), 1.0f, 2e-3f);
  EXPECT_NEAR(diffuse.at(32, 32, 1), 0.5f, 2e-3f);
}
