#pragma once

#include "app/model/build_guide.h"

#include <QFrame>

class QLabel;

namespace app {

/// What the guide through a first build asks for, one thing at a time, with a way to begin again and to leave. Hidden
/// while the guide is off.
class GuideBox : public QFrame
{
    Q_OBJECT

public:
    /// The guide must outlive it.
    explicit GuideBox(BuildGuide &guide, QWidget *parent = nullptr);

    /// Returns what is asked for; empty while the guide is off.
    QString text() const;

private:
    void refresh();

    BuildGuide &m_guide;
    QLabel *m_count;
    QLabel *m_text;
};

}
