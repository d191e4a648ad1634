TEST(@test@, NamesItsFormat) {
  lumen::testing::Scene scene;
  const auto& exporter = static_cast<lumen::Exporter&>(scene.add("exporter.@name@", "writer"));
  ASSERT_EQ(exporter.formats().size(), 1u);
  EXPECT_EQ(exporter.formats().front().extension, ".@name@");
}
