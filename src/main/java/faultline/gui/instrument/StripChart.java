package faultline.gui.instrument;

import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.TextSize;
import faultline.world.SensorSnapshot;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JToggleButton;

/** A chart of values over time, with a choice of signals and a button that holds it still. */
public final class StripChart extends JPanel {

    private static final int MIN_CHOICE_WIDTH = 64;

    private final StripView view = new StripView();
    private final JComboBox<SignalGroup> choice = new JComboBox<>();
    private final StripLegend legend = new StripLegend();
    private final JToggleButton fitValues = new JToggleButton(Glyph.FIT.icon());
    private final JToggleButton freeze = new JToggleButton(Glyph.PAUSE.icon());
    private List<String> sensors = List.of("");

    /** Creates an empty chart. */
    public StripChart() {
        super(new BorderLayout());
        choice.getAccessibleContext().setAccessibleName(Messages.get("strip.choice"));
        choice.setToolTipText(Messages.get("strip.choice.tip"));
        choice.addActionListener(event -> updateSignal());
        freeze.getAccessibleContext().setAccessibleName(Messages.get("strip.hold"));
        freeze.setToolTipText(Messages.get("strip.hold.tip"));
        freeze.addActionListener(event -> view.setFrozen(freeze.isSelected()));
        fitValues.getAccessibleContext().setAccessibleName(Messages.get("strip.fit"));
        fitValues.setToolTipText(Messages.get("strip.fit.tip"));
        fitValues.addActionListener(event -> view.setFromZero(!fitValues.isSelected()));
        new StripChartMouse(view, this::freeze).install();
        JPanel bar = new JPanel();
        bar.setLayout(new BoxLayout(bar, BoxLayout.LINE_AXIS));
        bar.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 4));
        choice.setPrototypeDisplayValue(widestSignal());
        choice.setMaximumSize(choice.getPreferredSize());
        choice.setMinimumSize(new Dimension(TextSize.scaled(MIN_CHOICE_WIDTH), choice.getPreferredSize().height));
        freeze.setMinimumSize(freeze.getPreferredSize());
        fitValues.setMinimumSize(fitValues.getPreferredSize());
        bar.add(choice);
        bar.add(Box.createHorizontalStrut(6));
        bar.add(freeze);
        bar.add(Box.createHorizontalStrut(2));
        bar.add(fitValues);
        bar.add(Box.createHorizontalStrut(10));
        bar.add(legend);
        add(bar, BorderLayout.NORTH);
        add(view, BorderLayout.CENTER);
    }

    /** Returns the group with the longest name for a typical robot. */
    private SignalGroup widestSignal() {
        Stream<String> names = Stream.of(
                Messages.get("signal.distance"),
                Messages.get("signal.terms"),
                Messages.get("signal.volts"),
                Messages.get("signal.sensor", "front-right"));
        String longest = names.max(Comparator.comparingInt(getFontMetrics(choice.getFont())::stringWidth))
                .orElseThrow();
        return new SignalGroup(longest + "  ", "", List.of());
    }

    private void freeze(boolean on) {
        freeze.setSelected(on);
        view.setFrozen(on);
    }

    /** Lets the chart follow the run again, over the initial time span. */
    void release() {
        view.setSpan(TimeSpan.DEFAULT);
        freeze(false);
    }

    private void updateSignal() {
        if (choice.getSelectedItem() instanceof SignalGroup signal) {
            view.setSignal(signal);
            legend.setSignal(signal);
        }
    }

    /** Shows a frame with the recording of its run. */
    public void setFrame(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        updateChoices(frame.snapshot().sensors());
        view.setFrame(frame);
    }

    /** Updates the choices for another robot; the selected index is kept if it still exists. */
    private void updateChoices(List<SensorSnapshot> present) {
        List<String> ids = present.stream().map(sensor -> sensor.spec().id()).toList();
        if (!ids.equals(sensors)) {
            sensors = ids;
            int chosen = Math.max(0, choice.getSelectedIndex());
            choice.removeAllItems();
            SignalGroup.allOf(present).forEach(choice::addItem);
            choice.setMaximumRowCount(choice.getItemCount());
            choice.setSelectedIndex(chosen < choice.getItemCount() ? chosen : 0);
        }
    }

    StripView view() {
        return view;
    }
}
