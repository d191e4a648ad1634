/// Techniques of one kind drawn one after the other, and how each differs from one of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <lumen/editor.h>

#include "difference.h"

class Comparison {
 public:
  struct Row {
    std::string instance, type;
    Difference difference;         ///< from the reference
    double milliseconds = 0;
    std::size_t bytes = 0;
    std::string failure;           ///< why it could not be drawn; empty = it was
    std::shared_ptr<const lumen::Image> picture;
  };

  /// `candidates`: instances of one kind; the reference is drawn first, whether or not it is among them.
  Comparison(std::string view, lumen::Kind kind, lumen::InstanceState reference, std::vector<lumen::InstanceState> candidates);

  /// Goes on for about `seconds`. False once all are drawn.
  bool step(lumen::Workbench& workbench, double seconds);
  float progress() const;          ///< 0..1
  std::string current() const;     ///< the instance being drawn
  const std::vector<Row>& rows() const { return rows_; }  ///< the finished ones; the reference first
  int width() const { return width_; }
  int height() const { return height_; }

  /// The table with a heading line, numbers with a dot. Throws lumen::Error if the file cannot be written.
  void write_csv(const std::string& file) const;

 private:
  void begin(lumen::Workbench& workbench);
  void finish();

  std::string view_;
  lumen::Kind kind_;
  std::vector<lumen::InstanceState> waiting_;  ///< the first is being drawn
  std::size_t count_ = 0;
  std::unique_ptr<lumen::Trial> trial_;
  std::vector<bool> counts_;
  std::vector<Row> rows_;
  int width_ = 0, height_ = 0;
};
