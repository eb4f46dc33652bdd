#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QFrame>
#include <QPixmap>
#include <QTimer>

#include <functional>
#include <map>

class QGridLayout;
class QToolButton;

namespace app {

/// Paints what a step looks like with a preset's values.
using PresetPainter = std::function<QPixmap(const lessons::Step &, const lessons::Preset &, QSize)>;

/// The presets of the open step as pictures: a click starts the step anew with one of them.
class PresetGallery : public QFrame
{
    Q_OBJECT

public:
    static constexpr QSize pictureSize{156, 104};

    PresetGallery(Session &session, const Theme &theme, PresetPainter painter, QWidget *parent = nullptr);

    /// Shows the gallery above or below `anchor`, where there is room.
    void popUp(const QWidget &anchor);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fill();
    void paintNext();
    bool goFrom(const QToolButton *card, int key);
    QToolButton *card(const lessons::Preset &preset);
    void choose(const lessons::Preset &preset);

    Session &m_session;
    const Theme &m_theme;
    PresetPainter m_painter;
    QGridLayout *m_grid;
    std::vector<QToolButton *> m_cards;
    std::map<QString, QPixmap> m_pictures; ///< painted before, by step, preset and scheme
    QTimer m_later;
    std::size_t m_painted = 0; ///< cards that have their picture
};

}
