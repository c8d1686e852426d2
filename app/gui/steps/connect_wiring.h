// What the steps Connect of every kind do alike between their presenter, the column of benches and the panel with real
// instruments.
#pragma once

#include "app/gui/bench/bench_opener.h"
#include "app/gui/bench/bench_panel.h"
#include "app/gui/bench/bench_presenter.h"
#include "app/gui/steps/connect_column.h"
#include "app/gui/steps/step_page.h"

#include <QObject>
#include <QString>

namespace straightedge::gui {

/// Real instruments become the bench once they are open, and give way where another bench is connected in their place.
template <typename Presenter>
void wireInstruments(QObject& page, Presenter& presenter, BenchPresenter& realBench) {
  QObject::connect(&realBench.opener(), &BenchOpener::opened, &page, [&](const auto& bench) {
    if (!presenter.useInstruments(bench)) {
      realBench.close();
    }
  });
  QObject::connect(&realBench.opener(), &BenchOpener::closed, &presenter, &Presenter::letGoOfInstruments);
  QObject::connect(&presenter, &Presenter::connectionChanged, &page, [&] {
    realBench.setCapturing(!presenter.mayChange());
    if (const auto& bench = realBench.opener().bench(); bench && !presenter.usesInstruments(bench.get())) {
      realBench.close();
    }
  });
}

/// Fills the column with the simulated bench and the real one, and leads its buttons to presenter and page. Returns the
/// panel of real instruments.
template <typename Presenter, typename Form>
BenchPanel* fillConnectColumn(ConnectColumn& column, const QString& aboutSimulated, Form& form, StepPage& page,
                              Presenter& presenter, BenchPresenter& realBench) {
  column.addBench(ConnectColumn::tr("Simulated bench"), aboutSimulated, &form);
  auto* panel = new BenchPanel(realBench, &column);
  column.addBench(ConnectColumn::tr("Instruments"), {}, panel, false);
  column.chooseBench(realBench.benchName().isEmpty() ? 0 : 1); // what was used last
  QObject::connect(&column, &ConnectColumn::connectWanted, &page,
                   [&presenter, &form] { presenter.connectSimulated(form.settings()); });
  QObject::connect(&column, &ConnectColumn::disconnectWanted, &presenter, &Presenter::disconnectBench);
  QObject::connect(&column, &ConnectColumn::nextWanted, &page,
                   [&page] { emit page.goToStep(ConnectColumn::tr("Capture")); });
  QObject::connect(&column, &ConnectColumn::detailsWanted, &page, &StepPage::detailsRequested);
  QObject::connect(&column, &ConnectColumn::takeOverWanted, &presenter, &Presenter::takeOverInstruments);
  return panel;
}

} // namespace straightedge::gui
