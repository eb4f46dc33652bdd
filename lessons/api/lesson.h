#pragma once

#include "lessons/api/step.h"

#include <QtPlugin>

#include <vector>

namespace lessons {

/// A lesson, loaded as a Qt plugin with the metadata {"id", "order", "title", "summary", "steps": [ids]}.
class Lesson
{
public:
    virtual ~Lesson() = default;
    /// Returns the steps in order. Their ids are those of the metadata.
    virtual std::vector<Step> steps() const = 0;
};

}

#define SpringstepLesson_iid "org.springstep.Lesson/2"
Q_DECLARE_INTERFACE(lessons::Lesson, SpringstepLesson_iid)
