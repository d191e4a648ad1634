TEST(@test@, MakesARingWithAHole) {
  lumen::testing::Scene scene({110, 110});
  scene.add("importer.@name@", "torus", R"({"radius": 0.7, "thickness": 0.2})");
  scene.add("renderer.surface", "ring", R"({"mesh": {"link": "torus.mesh"}})");
  const auto depth = scene.layer("depth");
  EXPECT_TRUE(std::isinf(depth.at(55, 55)));
  EXPECT_NEAR(depth.at(55 + 35, 55), 9.8f, 1e-2f);  // the crest, 0.7 units to the right, 0.2 toward the eye
}
