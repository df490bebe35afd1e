package faultline.gui.instrument;

import faultline.engine.Frame;
import faultline.gui.text.Texts;
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

/** A chart of numbers over time, with a choice of what it shows and a button that holds it still. */
public final class StripChart extends JPanel {

    private static final int LEAST_CHOICE = 100;

    private final StripView view = new StripView();
    private final JComboBox<Signal> choice = new JComboBox<>();
    private final StripLegend legend = new StripLegend();
    private final JToggleButton hold = new JToggleButton(Glyph.PAUSE.icon());
    private List<String> sensors = List.of("");

    /** A chart that shows nothing yet. */
    public StripChart() {
        super(new BorderLayout());
        choice.getAccessibleContext().setAccessibleName(Texts.text("strip.choice"));
        choice.setToolTipText(Texts.text("strip.choice.tip"));
        choice.addActionListener(event -> choose());
        hold.getAccessibleContext().setAccessibleName(Texts.text("strip.hold"));
        hold.setToolTipText(Texts.text("strip.hold.tip"));
        hold.addActionListener(event -> view.setHeld(hold.isSelected()));
        new StripHand(view, this::hold).install();
        JPanel bar = new JPanel();
        bar.setLayout(new BoxLayout(bar, BoxLayout.LINE_AXIS));
        bar.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 4));
        choice.setPrototypeDisplayValue(widest());
        choice.setMaximumSize(choice.getPreferredSize());
        choice.setMinimumSize(new Dimension(TextSize.scaled(LEAST_CHOICE), choice.getPreferredSize().height));
        hold.setMinimumSize(hold.getPreferredSize());
        bar.add(choice);
        bar.add(Box.createHorizontalStrut(6));
        bar.add(hold);
        bar.add(Box.createHorizontalStrut(10));
        bar.add(legend);
        add(bar, BorderLayout.NORTH);
        add(view, BorderLayout.CENTER);
    }

    /** The longest name that a usual robot has to choose from. */
    private Signal widest() {
        Stream<String> names = Stream.of(Texts.text("signal.distance"), Texts.text("signal.terms"), Texts.text("signal.volts"),
                Texts.text("signal.sensor", "front-right"));
        String longest = names.max(Comparator.comparingInt(getFontMetrics(choice.getFont())::stringWidth)).orElseThrow();
        return new Signal(longest + "  ", "", List.of());
    }

    private void hold(boolean on) {
        hold.setSelected(on);
        view.setHeld(on);
    }

    private void choose() {
        if (choice.getSelectedItem() instanceof Signal signal) {
            view.setSignal(signal);
            legend.setSignal(signal);
        }
    }

    /**
     * Shows a newer frame.
     *
     * @param frame with the recording of its run
     */
    public void show(Frame frame) {
        assert EventQueue.isDispatchThread();
        offer(frame.world().sensors());
        view.show(frame);
    }

    /** Another robot has other sensors; the choice stays at its place where there is one. */
    private void offer(List<SensorSnapshot> present) {
        List<String> ids = present.stream().map(sensor -> sensor.spec().id()).toList();
        if (!ids.equals(sensors)) {
            sensors = ids;
            int chosen = Math.max(0, choice.getSelectedIndex());
            choice.removeAllItems();
            Signal.of(present).forEach(choice::addItem);
            choice.setMaximumRowCount(choice.getItemCount());
            choice.setSelectedIndex(chosen < choice.getItemCount() ? chosen : 0);
        }
    }

    StripView view() {
        return view;
    }
}
