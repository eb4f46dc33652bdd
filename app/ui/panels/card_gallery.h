#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>
#include <QPixmap>
#include <QPointer>
#include <QTimer>

#include <functional>
#include <map>
#include <vector>

class QGridLayout;
class QToolButton;

namespace app {

/// What one card of a gallery shows and does.
struct GalleryCard
{
    QString title;
    QString help;
    QString tip; ///< with what a click does besides
    QString key; ///< of its picture: cards with the same one look the same
    std::function<QPixmap(QSize)> picture;
    std::function<void()> take; ///< called when the gallery is gone
};

/// Pictures to choose from, as a page over the window: by mouse, or by arrow keys and Return or Space. Esc or a click elsewhere
/// closes it.
class CardGallery : public QFrame
{
    Q_OBJECT

public:
    /// `picture`: the size of one, px. The pictures stand in so many columns.
    CardGallery(QSize picture, int columns, const Theme &theme, QWidget *parent = nullptr);

    /// Shows the gallery below or above `anchor`, where there is room.
    void popUp(QWidget &anchor);
    const std::vector<QToolButton *> &cards() const { return m_buttons; }

protected:
    /// The cards that there are now.
    virtual std::vector<GalleryCard> entries() = 0;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void fill();
    void paintNext();
    bool goFrom(const QObject *button, int key);
    QToolButton *buttonOf(std::size_t card);

    const QSize m_picture;
    const int m_columns;
    const Theme &m_theme;
    QGridLayout *m_grid;
    QPointer<QWidget> m_anchor; ///< what it hangs from
    std::vector<GalleryCard> m_cards;
    std::vector<QToolButton *> m_buttons;  ///< one a card
    std::map<QString, QPixmap> m_pictures; ///< painted before, by key and scheme
    QTimer m_later;
    std::size_t m_painted = 0; ///< cards that have their picture
};

}
