#pragma once

#include "lessons/api/step.h"

#include <QtPlugin>

#include <vector>

namespace lessons {

/// A lesson: a Qt plugin with metadata {"id", "order", "title", "summary", "steps": [ids]}.
class Lesson
{
public:
    virtual ~Lesson() = default;
    /// In order; their ids are those of the metadata.
    virtual std::vector<Step> steps() const = 0;
};

}

#define SpringstepLesson_iid "org.springstep.Lesson/2"
Q_DECLARE_INTERFACE(lessons::Lesson, SpringstepLesson_iid)
