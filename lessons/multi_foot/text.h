#pragma once

#include <QCoreApplication>

/// Translates the texts of this lesson.
struct Text
{
    Q_DECLARE_TR_FUNCTIONS(MultiFoot)
};
