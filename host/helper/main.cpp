/// lumenshop-helper WORKERS_FOLDER: the helper process. Descriptor 3 is its connection to the program.
#include <exception>

#include "helper/zygote.h"

int main(int count, char** arguments) try {
  if (count != 2) return 2;
  lumenshop::Zygote zygote(lumenshop::Channel(lumen::Descriptor(3)), arguments[1]);
  zygote.run();
  return 0;
} catch (const std::exception&) {
  return 1;  // the program sees the closed connection
}
