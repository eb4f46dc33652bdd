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

/// The content of one gallery card, and the action that a click runs.
struct GalleryCard
{
    QString title;
    QString help;
    QString tip; ///< also says what a click does
    QString key; ///< of the picture: cards with the same key share one picture
    std::function<QPixmap(QSize)> picture;
    std::function<void()> take; ///< called after the gallery has closed
};

/// A pop-up page of pictures to choose from. The learner chooses by mouse, or with the arrow keys and Return
/// or Space. Esc or a click elsewhere closes it.
class CardGallery : public QFrame
{
    Q_OBJECT

public:
    /// `picture` is the size of one picture in px; `columns` is the number of pictures in a row.
    CardGallery(QSize picture, int columns, const Theme &theme, QWidget *parent = nullptr);

    /// Shows the gallery below `anchor`, or above it if there is more room.
    void popUp(QWidget &anchor);
    const std::vector<QToolButton *> &cards() const { return m_buttons; }

protected:
    /// Returns the cards to show now.
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
    QPointer<QWidget> m_anchor; ///< the widget that opened the gallery
    std::vector<GalleryCard> m_cards;
    std::vector<QToolButton *> m_buttons;  ///< one per card
    std::map<QString, QPixmap> m_pictures; ///< already painted, by key and colour scheme
    QTimer m_timer;
    std::size_t m_painted = 0; ///< number of cards that have their picture
};

}
