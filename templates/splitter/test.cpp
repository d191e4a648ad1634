TEST(@test@, OpensAGapBetweenTwoSlices) {
  lumen::testing::Scene scene({110, 110});
  scene.add("splitter.@name@", "slices", R"({"slices": 2, "gap": 0.2})");
  scene.surface("plate", lumen::testing::rectangle(1, 1), R"({"splitter": "slices"})");
  const auto depth = scene.layer("depth");
  EXPECT_TRUE(std::isinf(depth.at(55, 55)));
  EXPECT_FALSE(std::isinf(depth.at(55 + 8, 55)));  // a pixel is 0.02 units: the gap ends 5 pixels from the middle
  EXPECT_FALSE(std::isinf(depth.at(55 - 9, 55)));
}
