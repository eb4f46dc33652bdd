#pragma once

#include "app/model/session.h"
#include "app/ui/panels/card_gallery.h"

namespace app {

/// The examples of the open workshop as pictures; a click opens one in place of what is built.
class ExampleGallery : public CardGallery
{
    Q_OBJECT

public:
    ExampleGallery(Session &session, const Theme &theme, QWidget *parent = nullptr);

protected:
    std::vector<Card> contents() const override;
    QPixmap picture(std::size_t index) override;
    void take(std::size_t index) override;

private:
    Session &m_session;
};

}
