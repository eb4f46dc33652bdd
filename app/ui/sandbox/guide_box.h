#pragma once

#include "app/model/sandbox/build_guide.h"

#include <QFrame>

class QLabel;

namespace app {

/// A box with the current instruction of the guide through a first build, and buttons to restart or leave the
/// guide. It is hidden while the guide is off.
class GuideBox : public QFrame
{
    Q_OBJECT

public:
    /// The guide must outlive the box.
    explicit GuideBox(BuildGuide &guide, QWidget *parent = nullptr);

    /// Returns the current instruction, or an empty text while the guide is off.
    QString text() const;

private:
    void refresh();

    BuildGuide &m_guide;
    QLabel *m_count;
    QLabel *m_text;
};

}
