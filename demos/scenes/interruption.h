#pragma once

#include <functional>

namespace bullet_buoyancy::scenes {

/// What a program exits with that was asked to end before its work was done.
inline constexpr int interruptedStatus = 130;

/// Thrown between two steps of a scene, or parts of a study, once the program is asked to end.
struct Interruption {};

/// Whether SIGINT (Ctrl-C) or SIGTERM has asked the program to end. False where nobody heeds them.
bool isInterrupted();
void throwIfInterrupted();

/// Works until it is done, or interrupted: false. What it has added to by then stays.
bool untilInterrupted(const std::function<void()>& work);

/// Runs a demo so that SIGINT and SIGTERM end it early, after it has written what is done; a second one ends
/// it at once. Returns its exit status, or after a word to standard error `interruptedStatus`.
int runInterruptibly(const char* demo, const std::function<int()>& run);

}  // namespace bullet_buoyancy::scenes
