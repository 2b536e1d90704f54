// Defines a bounded queue from one producer thread to one consumer thread. push() never allocates and returns false if
// the queue is full.
#pragma once

#include <boost/lockfree/spsc_queue.hpp>
#include <cstddef>

namespace handrail {

template <class T, std::size_t Capacity>
using SpscRing = boost::lockfree::spsc_queue<T, boost::lockfree::capacity<Capacity>>;

}  // namespace handrail
