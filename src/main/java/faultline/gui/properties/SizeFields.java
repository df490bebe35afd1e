package faultline.gui.properties;

import faultline.geometry.Vector2;
import faultline.gui.edit.PointShapes;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.PendingField;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The size of an obstacle: two lengths, or points. */
final class SizeFields {

    private static final double MIN_SIZE = 0.001;
    private static final double MAX_SIZE = 10_000;
    /** The size of a shape that cannot be changed here. */
    private static final Size NO_FIELDS = ofPoints(List.of(), null);

    private static final ObstacleShape.ShapeCases<Size> SIZES = new ObstacleShape.ShapeCases<>(
            rectangle ->
                    ofLengths("rectangle", rectangle.width(), rectangle.height(), ObstacleShape.RectangleShape::new),
            circle -> ofLengths("circle", circle.radius(), Double.NaN, (r, none) -> new ObstacleShape.CircleShape(r)),
            ellipse -> ofLengths("ellipse", ellipse.rx(), ellipse.ry(), ObstacleShape.EllipseShape::new),
            polygon -> ofPoints(polygon.points(), SizeFields::polygon),
            wall -> ofPoints(wall.points(), ObstacleShape.WallShape::new),
            plan -> NO_FIELDS);

    /**
     * The size of a shape.
     *
     * @param kind the last part of the keys of the labels
     * @param first the first length, metres; not a number if there is none
     * @param second the second length, metres; not a number if there is none
     * @param resized returns a shape of the same kind with other lengths; null if it has none
     * @param points the points, empty if it has lengths
     * @param redrawn returns a shape of the same kind with other points; null if it has none
     */
    record Size(
            String kind,
            double first,
            double second,
            BiFunction<Double, Double, ObstacleShape> resized,
            List<Vector2> points,
            Function<List<Vector2>, ObstacleShape> redrawn) {}

    private final Predicate<ObstacleShape> onChange;
    private final JLabel firstLabel = new JLabel();
    private final JLabel secondLabel = new JLabel();
    private final NumberSpinner first =
            new NumberSpinner("0.00##", MIN_SIZE, MAX_SIZE, 0.05, value -> change(value, second().doubleValue()));
    private final NumberSpinner second =
            new NumberSpinner("0.00##", MIN_SIZE, MAX_SIZE, 0.05, value -> change(first().doubleValue(), value));
    private final PointsField points = new PointsField("obstacle.points", this::changePoints);
    private Size size = NO_FIELDS;

    SizeFields(Predicate<ObstacleShape> onChange) {
        this.onChange = onChange;
        RefreshSteps.add(firstLabel, label -> setLabels(size.kind()));
    }

    private NumberSpinner first() {
        return first;
    }

    private NumberSpinner second() {
        return second;
    }

    /** Adds three rows to a form. */
    void addTo(JPanel form, int row) {
        firstLabel.setLabelFor(first);
        secondLabel.setLabelFor(second);
        form.add(firstLabel, FormConstraints.cell(0, row));
        form.add(first.withColumns(8), FormConstraints.cell(1, row));
        form.add(secondLabel, FormConstraints.cell(0, row + 1));
        form.add(second.withColumns(8), FormConstraints.cell(1, row + 1));
        form.add(FormConstraints.label("obstacle.points", points), FormConstraints.cell(0, row + 2));
        form.add(points, FormConstraints.fillRow(1, row + 2));
    }

    /** Applies what is typed, or shows the present size if it is not allowed. */
    void commitOrRevert() {
        first.commitPendingEdit();
        second.commitPendingEdit();
        points.commitOrRevert();
    }

    /** Shows the present size in place of what is typed. */
    void discardPendingEdits() {
        Stream.of(first, second, points).forEach(PendingField::discardPendingEdit);
    }

    private void setLabels(String kind) {
        String key = "obstacle.size." + kind;
        String firstText = Messages.get(key + ".first");
        if (!firstText.equals(firstLabel.getText())) {
            firstLabel.setText(firstText);
            secondLabel.setText(Messages.get(key + ".second"));
            first.withName(key + ".first");
            second.withName(key + ".second");
        }
    }

    private boolean change(double newFirst, double newSecond) {
        return size.resized() != null && onChange.test(size.resized().apply(newFirst, newSecond));
    }

    private boolean changePoints(List<Vector2> entered) {
        try {
            return size.redrawn() != null && onChange.test(size.redrawn().apply(entered));
        } catch (IllegalArgumentException notAllowed) {
            return false;
        }
    }

    /** Shows a shape, or disabled fields if it is null. */
    void setShape(ObstacleShape shapeOrNull) {
        size = shapeOrNull == null ? NO_FIELDS : shapeOrNull.match(SIZES);
        setLabels(size.kind());
        show(first, size.first());
        show(second, size.second());
        points.setEnabled(!size.points().isEmpty());
        points.setPoints(size.points());
    }

    private static void show(NumberSpinner field, double value) {
        field.setEnabled(!Double.isNaN(value));
        field.setWorldValue(value);
    }

    private static Size ofLengths(
            String kind, double first, double second, BiFunction<Double, Double, ObstacleShape> resized) {
        return new Size(kind, first, second, resized, List.of(), null);
    }

    private static ObstacleShape polygon(List<Vector2> points) {
        ObstacleShape polygon = new ObstacleShape.PolygonShape(points);
        if (PointShapes.areOnOneLine(points)) {
            throw new IllegalArgumentException("a polygon without area");
        }
        return polygon;
    }

    private static Size ofPoints(List<Vector2> points, Function<List<Vector2>, ObstacleShape> redrawn) {
        return new Size("rectangle", Double.NaN, Double.NaN, null, points, redrawn);
    }
}
