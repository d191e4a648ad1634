TEST(@test@, MovesASphereTowardTheEye) {
  lumen::testing::Scene scene({64, 64});
  scene.give("ball", lumen::testing::sphere(256, 0.5f));
  scene.add("filter.@name@", "grown", R"({"input": {"link": "ball.mesh"}, "distance": 0.25})");
  scene.add("renderer.surface", "surface", R"({"mesh": {"link": "grown.mesh"}})");
  EXPECT_NEAR(scene.layer("depth").at(32, 32), 9.25f, 2e-3f);
}
