TEST(@test@, LeavesAPlateFree) {
  lumen::testing::Scene scene({64, 64});
  scene.add("occlusion.@name@", "occlusion");
  scene.surface("plate", lumen::testing::rectangle(), "{}");
  EXPECT_NEAR(scene.layer("occlusion").at(32, 32), 0.0f, 1e-4f);
}
