#pragma once
/// How a program that calls the library ends a long call: from inside of it, by an exception.

namespace limn::base {

/// Called now and then, by the thread that set it, while that thread is in a loop of the library
/// (parallel.h). What it throws is thrown on by the function of the library that was called; all
/// that this has made so far is freed.
using InterruptCheck = void (*)();

/// Sets the check of the calling thread; nullptr: none (at first). Returns the one before.
InterruptCheck set_interrupt_check(InterruptCheck check);

/// Calls the check of the calling thread, if it has one.
void check_interrupt();

}  // namespace limn::base
