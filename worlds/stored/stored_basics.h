// Packs parts that occur in several kinds of stored values. Private to this folder.
#pragma once

#include "worlds/scene/scene.h"
#include "worlds/stored/archive.h"

namespace handrail::stored {

template <class A, Is<FeatureId> T>
void fields(A& a, T& v) {
    auto& [value] = v;
    a(value);
}
template <class A, Is<TextIn> T>
void fields(A& a, T& v) {
    auto& [language, text] = v;
    a(language, text);
}
template <class A, Is<Aabb> T>
void fields(A& a, T& v) {
    auto& [least, most] = v;
    a(least, most);
}

}  // namespace handrail::stored
