TEST(@test@, DrawsThePointThatFacesTheEye) {
  lumen::testing::Scene scene({65, 65});
  scene.give("ball", lumen::testing::sphere(64));
  scene.add("renderer.@name@", "points", R"({"mesh": {"link": "ball.mesh"}, "size": 5})");
  EXPECT_NEAR(scene.layer("depth").at(32, 32), 9.0f, 1e-2f);
}
