#include <cstddef>

std::size_t copyOf(const char* text);

int main(int argc, char** argv) {
    return argc > 1 && copyOf(argv[1]) == 0 ? 1 : 0;
}
