#include "scenes/interruption.h"

#include <csignal>
#include <cstdio>

namespace bullet_buoyancy::scenes {

namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void noteInterruption(int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

bool isInterrupted() {
    return interrupted != 0;
}

void throwIfInterrupted() {
    if (isInterrupted()) throw Interruption();
}

bool untilInterrupted(const std::function<void()>& work) {
    try {
        work();
    } catch (const Interruption&) {
        return false;
    }
    return true;
}

int runInterruptibly(const char* demo, const std::function<int()>& run) {
    std::signal(SIGINT, noteInterruption);
    std::signal(SIGTERM, noteInterruption);
    int status = 0;
    untilInterrupted([&] { status = run(); });
    if (!isInterrupted()) return status;
    std::fprintf(stderr, "%s: interrupted\n", demo);
    return interruptedStatus;
}

}  // namespace bullet_buoyancy::scenes
