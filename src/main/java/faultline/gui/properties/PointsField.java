package faultline.gui.properties;

import faultline.geometry.Vector2;
import faultline.gui.panel.ControlPanel;
import faultline.gui.panel.RefusalNote;
import faultline.gui.text.Messages;
import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.UiText;
import faultline.io.DecimalText;
import faultline.scenario.xml.ScenarioLimits;
import java.awt.Dimension;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import javax.swing.JTextField;

/**
 * A field for points, written as {@code x,y x,y}. If the text is not allowed, a note below the field says why; the text
 * stays until Escape is pressed or the focus leaves the field, which shows the old points again.
 */
final class PointsField extends JTextField implements ControlPanel.PendingField {

    private static final int COLUMNS = 16;

    private final transient Predicate<List<Vector2>> onChange;
    private final transient RefusalNote note = new RefusalNote(this);
    private transient List<Vector2> shown = List.of();

    /**
     * Creates a field without points. {@code onChange} receives those that the user enters and returns whether they are
     * allowed.
     */
    PointsField(String key, Predicate<List<Vector2>> onChange) {
        super(COLUMNS);
        this.onChange = onChange;
        UiText.name(this, key);
        UiText.tip(this, key + ".tip");
        addActionListener(event -> commitPendingEdit());
        KeyBindings.bind(this, "ESCAPE", this::revert);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                commit();
                setText(format(shown));
            }
        });
    }

    /** Returns half of the usual width, because the text scrolls in the field. */
    @Override
    public Dimension getMinimumSize() {
        Dimension size = super.getMinimumSize();
        return new Dimension(size.width / 2, size.height);
    }

    private void revert() {
        setText(format(shown));
        note.hide();
    }

    @Override
    public boolean commitPendingEdit() {
        List<Vector2> before = shown;
        if (commit()) {
            setText(format(shown));
        }
        return !shown.equals(before);
    }

    /** Applies the text; returns false if it is not allowed. */
    private boolean commit() {
        Optional<List<Vector2>> entered = getText().isBlank() ? Optional.of(List.of()) : parse(getText());
        if (entered.isEmpty()) {
            note.showBriefly(Messages.get("obstacle.points.invalid"));
            return false;
        }
        if (!entered.get().equals(shown)) {
            if (!onChange.test(entered.get())) {
                note.showBriefly(Messages.get("obstacle.points.refused"));
                return false;
            }
            shown = entered.get();
        }
        note.hide();
        return true;
    }

    /** Shows points, unless the user is typing. */
    void setPoints(List<Vector2> points) {
        if (!points.equals(shown) && !(isFocusOwner() && !getText().equals(format(shown)))) {
            shown = points;
            setText(format(points));
            setCaretPosition(0);
        }
    }

    static String format(List<Vector2> points) {
        return points.stream()
                .map(point -> DecimalText.format(point.x()) + "," + DecimalText.format(point.y()))
                .collect(Collectors.joining(" "));
    }

    /** Returns the points of a text, empty if it is invalid. */
    static Optional<List<Vector2>> parse(String text) {
        List<Vector2> points = new ArrayList<>();
        for (String pair : text.strip().split("\\s+")) {
            List<Double> numbers = new ArrayList<>();
            for (String number : pair.split(",", -1)) {
                DecimalText.parse(number)
                        .map(exact -> DecimalText.toDouble(exact, number))
                        .filter(value -> Math.abs(value) <= ScenarioLimits.MAX_COORDINATE)
                        .ifPresent(numbers::add);
            }
            if (numbers.size() != 2 || pair.chars().filter(sign -> sign == ',').count() != 1) {
                return Optional.empty();
            }
            points.add(new Vector2(numbers.get(0), numbers.get(1)));
        }
        return Optional.of(points);
    }
}
