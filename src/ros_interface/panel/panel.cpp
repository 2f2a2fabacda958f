#include "ros_interface/panel/panel.h"

#include <rviz/visualization_manager.h>

#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QToolTip>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>
#include <utility>

#include "repertoire/describe_entry.h"
#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

constexpr int kRefresh_ms = 100;
constexpr int kLook_ms = 500;
constexpr int kSmallestWidth = 260;

// A function that another thread wants to be called in the panel's.
class Posted : public QEvent {
 public:
  static QEvent::Type kind() {
    static const int kind = QEvent::registerEventType();
    return static_cast<QEvent::Type>(kind);
  }

  explicit Posted(std::function<void()> body) : QEvent(kind()), body_(std::move(body)) {}
  void call() const { body_(); }

 private:
  std::function<void()> body_;
};

}  // namespace

Panel::Panel(QWidget* parent)
    : rviz::Panel(parent),
      tabs_(new QTabWidget(this)),
      learning_(new LearningTab([this](Ask ask) { link_->ask(ask); }, this)),
      walking_(new WalkingTab({[this](Ask ask) { link_->ask(ask); },
                               [this](const geometry_msgs::PoseStamped& goal) { link_->go(goal); }},
                              this)),
      repertoire_(new RepertoireTab(
          {[this](const std::string& file) { link_->load(file); },
           [this](const EntryFilter& filter) { setFilter(filter); },
           [this](std::int64_t entry_id, bool play) { link_->choose(entry_id, play); }},
          this)),
      nodes_(new QTableWidget(0, 3, this)),
      answer_(new QLabel(this)) {
  tabs_->setObjectName("tabs");
  tabs_->addTab(learning_, "Learn");
  tabs_->addTab(walking_, "Walk");
  tabs_->addTab(repertoire_, "Repertoire");
  tabs_->addTab(nodes_, "Nodes");
  makeNodeTable();
  answer_->setObjectName("answer");
  answer_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(tabs_, 1);
  column->addWidget(answer_);
  setMinimumWidth(kSmallestWidth);
  link_ = std::make_unique<PanelLink>(
      ros::NodeHandle(), model_,
      PanelLink::Panel{[this](std::function<void()> body) {
                         QCoreApplication::postEvent(this, new Posted(std::move(body)));
                       },
                       [this] { refreshSoon(); },
                       [this](const std::string& sentence) { tell(sentence); }});
  refresh_timer_.setSingleShot(true);
  connect(&refresh_timer_, &QTimer::timeout, [this] { refresh(); });
  connect(&look_timer_, &QTimer::timeout, [this] { link_->lookAround(); });
  look_timer_.start(kLook_ms);
  refresh();
}

Panel::~Panel() = default;

void Panel::onInitialize() {
  pointer_ = std::make_unique<PointerWatch>(
      *vis_manager_, *vis_manager_->getRenderPanel(), names::kRepertoireOriginFrame,
      [this](const std::optional<PointerWatch::Place>& place) { point(place); });
}

/// Tells of the entry below the mouse.
void Panel::point(const std::optional<PointerWatch::Place>& place) {
  const auto entry = place ? model_.entryAt(place->x_m, place->y_m) : std::nullopt;
  if (!entry) {
    QToolTip::hideText();
    return;
  }
  link_->publishPointer(place->x_m, place->y_m);
  QToolTip::showText(place->on_screen, QString::fromStdString(describe(*entry)));
}

bool Panel::event(QEvent* event) {
  if (event->type() != Posted::kind()) return rviz::Panel::event(event);
  static_cast<const Posted*>(event)->call();
  return true;
}

void Panel::makeNodeTable() {
  nodes_->setObjectName("nodes");
  nodes_->setHorizontalHeaderLabels({"node", "state", "why"});
  nodes_->verticalHeader()->hide();
  nodes_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  nodes_->horizontalHeader()->setStretchLastSection(true);
  nodes_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  nodes_->setWordWrap(true);
}

void Panel::setFilter(const EntryFilter& filter) {
  model_.setFilter(filter);
  link_->publishFilter(filter);
  refreshSoon();
  Q_EMIT configChanged();
}

void Panel::refreshSoon() {
  if (!refresh_timer_.isActive()) refresh_timer_.start(kRefresh_ms);
}

void Panel::refresh() {
  learning_->show(model_);
  walking_->show(model_);
  repertoire_->show(model_);
  refreshNodes();
}

void Panel::refreshNodes() {
  const std::vector<PanelModel::NodeLine> lines = model_.nodes();
  nodes_->setRowCount(static_cast<int>(lines.size()));
  int row = 0;
  for (const PanelModel::NodeLine& line : lines) {
    int column = 0;
    for (const std::string& text : {line.name, line.state, line.reason}) {
      auto* item = new QTableWidgetItem(QString::fromStdString(text));
      item->setToolTip(item->text());
      QFont font = item->font();
      font.setBold(!line.is_well);
      item->setFont(font);
      nodes_->setItem(row, column++, item);
    }
    ++row;
  }
}

void Panel::tell(const std::string& sentence) {
  answer_->setText(QString::fromStdString(sentence));
}

void Panel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Tab", tabs_->currentIndex());
  walking_->save(config);
  repertoire_->save(config);
}

void Panel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  int tab = 0;
  if (config.mapGetInt("Tab", &tab)) tabs_->setCurrentIndex(tab);
  walking_->load(config);
  repertoire_->load(config);
}

}  // namespace hexapod

PLUGINLIB_EXPORT_CLASS(hexapod::Panel, rviz::Panel)
