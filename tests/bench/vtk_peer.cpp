/// The peer of `lumenshop bench`: draws a mesh off screen with VTK, the camera turned by half a degree each frame.
///   vtk-peer FILE WIDTH HEIGHT FRAMES [--ssao SAMPLES | --transparent weighted|exact]
/// Prints the quartiles of a frame in milliseconds, the camera and the peak memory as JSON. Debian's VTK needs an X server: xvfb-run.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDualDepthPeelingPass.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOpaquePass.h>
#include <vtkOrderIndependentTranslucentPass.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkPolyDataReader.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkSTLReader.h>
#include <vtkSequencePass.h>
#include <vtkSmartPointer.h>
#include <vtkTranslucentPass.h>
#include <vtkXMLPolyDataReader.h>

namespace {

template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(const std::string& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> read(const std::string& file) {
  const auto is = [&](const char* extension) { return file.ends_with(extension); };
  auto mesh = is(".vtp")   ? read_with<vtkXMLPolyDataReader>(file)
              : is(".vtk") ? read_with<vtkPolyDataReader>(file)
              : is(".stl") ? read_with<vtkSTLReader>(file)
              : is(".obj") ? read_with<vtkOBJReader>(file)
                           : read_with<vtkPLYReader>(file);
  if (!mesh || mesh->GetNumberOfCells() == 0) throw std::runtime_error(file + ": no cells");
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

void add_light(vtkRenderer* renderer, double x, double y, double z, double intensity) {
  vtkNew<vtkLight> light;
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetPositional(false);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

/// Everything is transparent: by weighted sums, or by eight dual depth peels.
void make_transparent(vtkRenderer* renderer, vtkActor* actor, const std::string& technique) {
  actor->GetProperty()->SetOpacity(0.4);
  actor->ForceTranslucentOn();
  vtkNew<vtkTranslucentPass> surfaces;
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  if (technique == "exact") {
    vtkNew<vtkDualDepthPeelingPass> peeling;
    peeling->SetTranslucentPass(surfaces);
    peeling->SetMaximumNumberOfPeels(8);
    peeling->SetOcclusionRatio(0);
    passes->AddItem(peeling);
  } else if (technique == "weighted") {
    vtkNew<vtkOrderIndependentTranslucentPass> weighted;
    weighted->SetTranslucentPass(surfaces);
    passes->AddItem(weighted);
  } else {
    throw std::runtime_error(technique + ": no such transparency");
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  renderer->SetPass(camera);
}

double at(const std::vector<double>& sorted, double fraction) { return sorted[std::size_t(fraction * double(sorted.size() - 1) + 0.5)]; }

int run(const std::string& file, int width, int height, int frames, int ssao_samples, const std::string& transparency) {
  const auto mesh = read(file);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetDiffuseColor(0.72, 0.04, 0.05);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(40);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->AutomaticLightCreationOff();
  add_light(renderer, 0.3, -1, 0.4, 1);
  add_light(renderer, -0.3, 1, -0.2, 0.4);
  if (ssao_samples > 0) {
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAOPass> pass;
    pass->SetDelegatePass(steps);
    pass->SetKernelSize(unsigned(ssao_samples));
    pass->SetRadius(0.05 * mesh->GetLength() / 2);
    pass->BlurOn();
    renderer->SetPass(pass);
  }

  if (!transparency.empty()) make_transparent(renderer, actor, transparency);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(30);
  camera->SetPosition(0, -1, 0);  // from the front, z up: as the program's own first view
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  double pivot[3];
  camera->GetFocalPoint(pivot);
  const double distance = camera->GetDistance();

  const auto draw = [&](int frame) {
    camera->Azimuth(frame % 40 < 20 ? 0.5 : -0.5);
    renderer->ResetCameraClippingRange();
    window->Render();
    window->WaitForCompletion();
  };
  for (int frame = 0; frame < 4; ++frame) draw(frame);
  std::vector<double> samples;
  for (int frame = 0; frame < frames; ++frame) {
    const auto begin = std::chrono::steady_clock::now();
    draw(frame);
    samples.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(samples.begin(), samples.end());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("{\"frame\": {\"first_quartile_ms\": %.3f, \"median_ms\": %.3f, \"third_quartile_ms\": %.3f}, \"pivot\": [%.9g, %.9g, %.9g], "
              "\"distance\": %.9g, \"triangles\": %lld, \"peak_memory_bytes\": %lld}\n",
              at(samples, 0.25), at(samples, 0.5), at(samples, 0.75), pivot[0], pivot[1], pivot[2], distance,
              static_cast<long long>(mesh->GetNumberOfCells()), 1024LL * usage.ru_maxrss);
  return 0;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count < 5 || argument_count == 6) {
    std::fputs("usage: vtk-peer FILE WIDTH HEIGHT FRAMES [--ssao SAMPLES | --transparent weighted|exact]\n", stderr);
    return 2;
  }
  try {
    const std::string option = argument_count > 6 ? arguments[5] : "", value = argument_count > 6 ? arguments[6] : "";
    return run(arguments[1], std::atoi(arguments[2]), std::atoi(arguments[3]), std::atoi(arguments[4]), option == "--ssao" ? std::atoi(value.c_str()) : 0,
               option == "--transparent" ? value : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "vtk-peer: %s\n", error.what());
    return 1;
  }
}
