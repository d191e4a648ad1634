TEST(@test@, HasATitle) {
  lumen::testing::Scene scene;
  EXPECT_EQ(static_cast<lumen::Editor&>(scene.add("editor.@name@", "panel")).title(), "@Title@");
}
