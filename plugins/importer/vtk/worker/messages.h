/// What VTK says while it works, gathered instead of printed.
#pragma once

#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

/// While it lives, VTK's errors and warnings of the process come here.
class Messages {
 public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  bool failed() const;                    ///< an error was among them
  /// The first error, or warning if there was none, as one line with its place: "aorta.vtp:5:10: not well-formed".
  std::string first(const std::string& file) const;

 private:
  class Window;
  vtkSmartPointer<vtkOutputWindow> previous_;
  vtkNew<Window> window_;
};
