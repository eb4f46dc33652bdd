#pragma once

#include <QString>

namespace lessons {

// A choice among many has titles with a group before them: "Stiff springs › at the limit". Those of a group stand in a
// row, and the panel offers a submenu for each group.

inline const QString groupEnd = QStringLiteral(" › ");

/// Returns the title of a choice with the group that it belongs to.
inline QString grouped(const QString &group, const QString &title)
{
    return group + groupEnd + title;
}

/// Returns the group of a title; empty where it names none.
inline QString groupOf(const QString &title)
{
    const qsizetype end = title.indexOf(groupEnd);
    return end < 0 ? QString() : title.left(end);
}

/// Returns a title without its group.
inline QString withoutGroup(const QString &title)
{
    const qsizetype end = title.indexOf(groupEnd);
    return end < 0 ? title : title.mid(end + groupEnd.size());
}

}
