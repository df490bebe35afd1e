package faultline.gui.properties;

import faultline.geometry.Vector2;
import faultline.gui.form.EnteredTextField;
import faultline.gui.text.Messages;
import faultline.io.DecimalText;
import faultline.scenario.xml.ScenarioLimits;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** A field for points, written as {@code x,y x,y}. */
final class PointsField extends EnteredTextField {

    private static final int COLUMNS = 16;

    private final transient Predicate<List<Vector2>> onChange;
    private transient List<Vector2> shown = List.of();

    /**
     * Creates a field without points. {@code onChange} receives those that the user enters and returns whether they are
     * allowed.
     */
    PointsField(String key, Predicate<List<Vector2>> onChange) {
        super(key, COLUMNS);
        this.onChange = onChange;
    }

    @Override
    protected String valueText() {
        return format(shown);
    }

    @Override
    protected Optional<String> apply(String text) {
        Optional<List<Vector2>> entered = text.isBlank() ? Optional.of(List.of()) : parse(text);
        if (entered.isEmpty()) {
            return Optional.of(Messages.get("obstacle.points.invalid"));
        }
        if (!entered.get().equals(shown)) {
            if (!onChange.test(entered.get())) {
                return Optional.of(Messages.get("obstacle.points.refused"));
            }
            shown = entered.get();
        }
        return Optional.empty();
    }

    /** Shows points, unless the user is typing. */
    void setPoints(List<Vector2> points) {
        if (!points.equals(shown) && !(isFocusOwner() && isEdited())) {
            shown = points;
            showValue();
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
