package faultline.gui.instrument;

import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.gui.action.ContextMenu;
import faultline.gui.action.ScrolledMenuLayout;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import faultline.gui.timeline.TimelineItem;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JToggleButton;
import javax.swing.UIManager;

/** A chart of values over time, with a choice of signals and a button that holds it still. */
public final class StripChart extends JPanel {

    private static final int MIN_CHOICE_WIDTH = 44;

    private final StripLegend legend = new StripLegend();
    private final StripView view = new StripView(legend::isComplete);
    private final JComboBox<SignalGroup> choice = new JComboBox<>();
    private final JButton add = new JButton(Glyph.ADD.icon());
    private final JToggleButton fitValues = new JToggleButton(Glyph.FIT.icon());
    private final JToggleButton freeze = new JToggleButton(Glyph.PAUSE.icon());
    private List<String> sensors = List.of();
    private transient List<SignalGroup> groups = List.of();
    /** Adds the actions of the window to the context menu. */
    private transient Consumer<JPopupMenu> menuExtension = menu -> {};
    /** The group that was chosen last, null for none. */
    private transient SignalGroup shownGroup;
    /** The lines of other groups that are shown beside those of the chosen one. */
    private final transient List<ChartLine> additions = new ArrayList<>();

    /** Creates an empty chart. */
    public StripChart() {
        super(new BorderLayout());
        name(choice, "strip.choice");
        choice.addActionListener(
                event -> chosen().filter(group -> group != shownGroup).ifPresent(this::showGroup));
        name(add, "strip.add");
        add.addActionListener(event -> ContextMenu.show(createAdditionsMenu(), add, 0, add.getHeight()));
        name(freeze, "strip.hold");
        freeze.addActionListener(event -> view.setFrozen(freeze.isSelected()));
        name(fitValues, "strip.fit");
        fitValues.addActionListener(event -> view.setRange(automaticRange()));
        new StripChartMouse(view, this::freeze, at -> ContextMenu.show(createMenu(), view, at.x, at.y)).install();
        JPanel bar = new JPanel();
        bar.setLayout(new BoxLayout(bar, BoxLayout.LINE_AXIS));
        bar.setBorder(BorderFactory.createEmptyBorder(3, 8, 2, 4));
        RefreshSteps.add(choice, box -> {
            setGroups(UnaryOperator.identity());
            fitChoice();
        });
        // As narrow as the buttons beside it, which stay pressed.
        RefreshSteps.add(add, self -> self.setBorder(UIManager.getBorder("ToggleButton.border")));
        add.setMinimumSize(add.getPreferredSize());
        freeze.setMinimumSize(freeze.getPreferredSize());
        fitValues.setMinimumSize(fitValues.getPreferredSize());
        bar.add(choice);
        bar.add(Box.createHorizontalStrut(6));
        bar.add(add);
        bar.add(Box.createHorizontalStrut(2));
        bar.add(freeze);
        bar.add(Box.createHorizontalStrut(2));
        bar.add(fitValues);
        bar.add(Box.createHorizontalStrut(10));
        bar.add(legend);
        add(bar, BorderLayout.NORTH);
        add(view, BorderLayout.CENTER);
    }

    /** Shows another group, without the lines and the scale that were chosen for the one before. */
    private void showGroup(SignalGroup group) {
        shownGroup = group;
        additions.clear();
        updateSignal();
        view.setRange(automaticRange());
    }

    private static void name(JComponent control, String key) {
        UiText.tip(UiText.name(control, key), key + ".tip");
    }

    private void fitChoice() {
        choice.setPrototypeDisplayValue(widestSignal());
        choice.setMaximumSize(choice.getPreferredSize());
        choice.setMinimumSize(new Dimension(TextSize.scaled(MIN_CHOICE_WIDTH), choice.getPreferredSize().height));
    }

    /** Returns the group with the longest name for a typical robot. */
    private SignalGroup widestSignal() {
        Stream<String> names = Stream.of(
                Messages.get("signal.distance"),
                Messages.get("signal.terms"),
                Messages.get("signal.volts"),
                Messages.get("signal.velocity"),
                Messages.get("signal.turnRate"),
                Messages.get("signal.sensor", "front-right"));
        String longest = names.max(Comparator.comparingInt(getFontMetrics(choice.getFont())::stringWidth))
                .orElseThrow();
        return new SignalGroup("", longest + "  ", "", List.of());
    }

    private void freeze(boolean on) {
        freeze.setSelected(on);
        view.setFrozen(on);
    }

    /** Lets the chart follow the run again, over the initial time span. */
    void release() {
        resetZoom();
        freeze(false);
    }

    private void resetZoom() {
        view.setSpan(TimeSpan.DEFAULT.endingAt(view.span().end()));
        view.setRange(automaticRange());
    }

    private ValueRange automaticRange() {
        return fitValues.isSelected() ? ValueRange.FITTED : ValueRange.FROM_ZERO;
    }

    private void updateSignal() {
        if (choice.getSelectedItem() instanceof SignalGroup signal) {
            add.setEnabled(!SignalGroup.additions(signal, groups).isEmpty());
            SignalGroup shown = signal.with(additions);
            view.setSignal(shown);
            legend.setSignal(shown);
        }
    }

    /**
     * Creates a menu of the lines with the same unit as the chosen signal. It stays open after a click, because several
     * lines are often added together.
     */
    JPopupMenu createAdditionsMenu() {
        JPopupMenu menu = new JPopupMenu();
        ScrolledMenuLayout.install(menu);
        additionItems().forEach(menu::add);
        return menu;
    }

    private Stream<JCheckBoxMenuItem> additionItems() {
        if (choice.getSelectedItem() instanceof SignalGroup signal) {
            List<ChartLine> lines = SignalGroup.additions(signal, groups);
            return IntStream.range(0, lines.size()).mapToObj(i -> additionItem(i + 1, lines.get(i)));
        }
        return Stream.empty();
    }

    private JCheckBoxMenuItem additionItem(int number, ChartLine line) {
        JCheckBoxMenuItem item = new JCheckBoxMenuItem("", additions.stream().anyMatch(line::showsSameAs));
        ContextMenu.number(item, number, line.name());
        item.addActionListener(event -> toggle(line));
        item.putClientProperty("CheckBoxMenuItem.doNotCloseOnMouseClick", true);
        return item;
    }

    /** Sets what adds the actions of the window to the context menu each time that it is opened. */
    public void setMenuExtension(Consumer<JPopupMenu> extension) {
        menuExtension = extension;
    }

    /** Creates the context menu: what the controls above the plot do, and the actions of the window. */
    JPopupMenu createMenu() {
        JPopupMenu menu = new StripMenu()
                .choice("strip.menu.signals", choice)
                .items("strip.menu.add", additionItems())
                .separator()
                .toggle("strip.menu.hold", freeze)
                .toggle("strip.menu.fit", fitValues)
                .action("strip.menu.reset", this::resetZoom)
                .menu();
        menuExtension.accept(menu);
        return menu;
    }

    private void toggle(ChartLine line) {
        if (!additions.removeIf(line::showsSameAs)) {
            additions.add(line);
        }
        updateSignal();
    }

    /** Sets the faults, switches and moves that are marked behind the lines. */
    void setItems(List<TimelineItem> items) {
        view.setItems(items);
    }

    /** Shows the lines of a reference run beside those of the run, null for none. */
    void setReference(ReferenceRun run) {
        legend.setReference(run);
        view.setReference(run);
    }

    /** Returns all that the chart shows; empty before the first frame. */
    public Optional<StripContent> content() {
        return view.content();
    }

    /** Gives the sensors the ids that they have in the next frame, as returned for the present ones. */
    void renameSensors(UnaryOperator<String> presentId) {
        sensors = sensors.stream().map(presentId).toList();
        setGroups(presentId);
    }

    /** Shows a frame with the recording of its run. */
    public void setFrame(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        List<String> present = frame.snapshot().robot().sensorIds();
        if (!present.equals(sensors)) {
            sensors = present;
            setGroups(UnaryOperator.identity());
        }
        view.setFrame(frame);
    }

    /**
     * Shows the groups of the robot in the current language, with the group, the lines and the scale that the user has
     * chosen; the first group if the robot lacks the sensor of the chosen one. {@code presentId} returns what a sensor
     * is called now.
     */
    private void setGroups(UnaryOperator<String> presentId) {
        Optional<SignalGroup> before = chosen().map(old -> old.withSensor(presentId));
        List<ChartLine> added =
                additions.stream().map(line -> line.withSensor(presentId)).toList();
        ValueRange range = view.range();
        groups = SignalGroup.allOf(sensors);
        SignalGroup kept = before.flatMap(old -> groups.stream()
                        .filter(group -> group.id().equals(old.id()))
                        .findFirst())
                .orElse(groups.get(0));
        choice.setModel(new DefaultComboBoxModel<>(groups.toArray(SignalGroup[]::new)));
        choice.setMaximumRowCount(choice.getItemCount());
        choice.setSelectedItem(kept);
        if (before.filter(old -> old.id().equals(kept.id())).isPresent()) {
            SignalGroup.additions(kept, groups).stream()
                    .filter(line -> added.stream().anyMatch(line::showsSameAs))
                    .forEach(additions::add);
            updateSignal();
            view.setRange(range);
        }
    }

    private Optional<SignalGroup> chosen() {
        return Optional.ofNullable((SignalGroup) choice.getSelectedItem());
    }

    StripView view() {
        return view;
    }
}
