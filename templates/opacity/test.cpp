TEST(@test@, CoversOneLayerByAlpha) {
  lumen::testing::Scene scene({64, 64});
  scene.add("transparency.weighted", "transparency");
  scene.add("opacity.@name@", "term", R"({"alpha": 0.25})");
  scene.surface("plate", lumen::testing::rectangle(), R"({"opacity": "term"})");
  EXPECT_NEAR(scene.layer("opacity").at(32, 32), 0.25f, 2e-3f);
}
