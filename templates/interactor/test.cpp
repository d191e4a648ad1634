TEST(@test@, BeginsWithoutPresses) {
  lumen::testing::Scene scene;
  scene.add("interactor.@name@", "counter");
  EXPECT_EQ(std::get<int>(scene.value("counter.presses")), 0);
  EXPECT_TRUE(scene.problems().empty());
}
