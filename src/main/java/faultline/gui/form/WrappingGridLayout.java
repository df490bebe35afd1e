package faultline.gui.form;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JViewport;

/**
 * A grid whose rows continue on further lines if the {@link NarrowingColumn} that contains it is too narrow for its
 * columns. All rows continue before the same columns, so that headings remain above their values, and before the label
 * of a field rather than after it. In a wider column and elsewhere it is a {@link GridBagLayout}.
 */
public final class WrappingGridLayout extends GridBagLayout {

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        int width = availableWidth(parent);
        return isWrapped(parent, width)
                ? new Dimension(
                        Math.max(width, minimumLayoutSize(parent).width),
                        placeCells(parent, width, (part, bounds) -> {}))
                : super.preferredLayoutSize(parent);
    }

    /** Returns a size as wide as the widest component, below which the column scrolls sideways. */
    @Override
    public Dimension minimumLayoutSize(Container parent) {
        Dimension grid = super.minimumLayoutSize(parent);
        int widest = cells(parent).mapToInt(GridCell::minWidth).max().orElse(0);
        return new Dimension(Math.min(grid.width, widest + horizontalInsets(parent)), grid.height);
    }

    @Override
    public void layoutContainer(Container parent) {
        int width = availableWidth(parent);
        if (isWrapped(parent, width)) {
            placeCells(parent, width, Component::setBounds);
        } else {
            super.layoutContainer(parent);
        }
    }

    private boolean isWrapped(Container parent, int width) {
        return width < super.minimumLayoutSize(parent).width;
    }

    /** Returns the width that the column leaves for a container, known before the container is laid out, pixels. */
    public static int availableWidth(Container parent) {
        int margins = 0;
        for (Container outer = parent.getParent(); outer != null; outer = outer.getParent()) {
            if (outer instanceof JViewport viewport) {
                boolean narrows = viewport.getView() instanceof NarrowingColumn && viewport.getWidth() > 0;
                return narrows ? viewport.getWidth() - margins : Integer.MAX_VALUE;
            }
            margins += horizontalInsets(outer);
        }
        return Integer.MAX_VALUE;
    }

    private static int horizontalInsets(Container container) {
        Insets insets = container.getInsets();
        return insets.left + insets.right;
    }

    private Stream<GridCell> cells(Container parent) {
        return Stream.of(parent.getComponents())
                .filter(Component::isVisible)
                .map(part -> new GridCell(part, getConstraints(part)))
                .sorted(Comparator.<GridCell>comparingInt(cell -> cell.at.gridy).thenComparingInt(GridCell::column));
    }

    /** Passes on the bounds of each component, and returns the height of all lines. */
    private int placeCells(Container parent, int width, BiConsumer<Component, Rectangle> target) {
        Insets insets = parent.getInsets();
        List<GridCell> cells = cells(parent).toList();
        Lines lines = new Lines(cells, width - insets.left - insets.right);
        int y = insets.top;
        for (List<PlacedCell> line : lines.placed()) {
            int height =
                    line.stream().mapToInt(placed -> placed.cell.height()).max().orElse(0);
            for (PlacedCell placed : line) {
                GridCell cell = placed.cell;
                int above =
                        (height - cell.part.getPreferredSize().height + cell.at.insets.top - cell.at.insets.bottom) / 2;
                target.accept(
                        cell.part,
                        new Rectangle(
                                insets.left + placed.x, y + above, placed.width, cell.part.getPreferredSize().height));
            }
            y += height;
        }
        return y + insets.bottom;
    }

    /** A component with its place in the grid. */
    private record GridCell(Component part, GridBagConstraints at) {

        int column() {
            return at.gridx;
        }

        boolean spans() {
            return at.gridwidth != 1;
        }

        boolean fills() {
            return at.fill == GridBagConstraints.HORIZONTAL;
        }

        /** Returns whether this is the label of a field, which follows it. */
        boolean isFieldLabel() {
            return part instanceof JLabel label && label.getLabelFor() != null;
        }

        /** Returns whether this may be a unit, which follows its field; a heading follows another one. */
        boolean isUnit() {
            return part instanceof MutedLabel;
        }

        /** Returns the least width of the component; the list of a combo box shows texts that the box cuts. */
        int minWidth() {
            int least = fills() ? part.getMinimumSize().width : part.getPreferredSize().width;
            return part instanceof JComboBox ? least / 2 : least;
        }

        int width() {
            return at.insets.left + part.getPreferredSize().width + at.insets.right;
        }

        int height() {
            return at.insets.top + part.getPreferredSize().height + at.insets.bottom;
        }
    }

    /** A component with its left edge and width in a line, pixels. */
    private record PlacedCell(GridCell cell, int x, int width) {

        int end() {
            return x + width;
        }
    }

    /** The division of all rows into lines of a width. */
    private static final class Lines {

        private final int width;
        private final List<GridCell> cells;
        private final TreeMap<Integer, Integer> columnWidths = new TreeMap<>();
        private final Map<Integer, Integer> lineOfColumn = new HashMap<>();
        private final Map<Integer, Integer> leftOfColumn = new HashMap<>();
        private int line;
        private int end;

        Lines(List<GridCell> cells, int width) {
            this.cells = cells;
            this.width = width;
            cells.forEach(cell -> columnWidths.merge(cell.column(), cell.spans() ? 0 : cell.width(), Math::max));
            divideColumns();
        }

        /** Divides the columns into lines; columns from one label of a field to the next stay together if they can. */
        private void divideColumns() {
            List<Integer> labels = cells.stream()
                    .filter(GridCell::isFieldLabel)
                    .map(GridCell::column)
                    .toList();
            List<List<Integer>> units = new ArrayList<>();
            for (int column : columnWidths.keySet()) {
                if (units.isEmpty() || labels.contains(column)) {
                    units.add(new ArrayList<>());
                }
                units.get(units.size() - 1).add(column);
            }
            units.forEach(this::addColumns);
            alignFields(units);
        }

        private void addColumns(List<Integer> unit) {
            int together = sumWidths(unit);
            if (end + together > width) {
                startLine();
            }
            int limit = together > width ? balancedWidth(unit) : width;
            for (int column : unit) {
                if (end + columnWidths.get(column) > limit) {
                    startLine();
                }
                lineOfColumn.put(column, line);
                leftOfColumn.put(column, end);
                end += columnWidths.get(column);
            }
            if (together > width) {
                startLine();
            }
        }

        private int sumWidths(List<Integer> columns) {
            return columns.stream().mapToInt(columnWidths::get).sum();
        }

        /** Returns the smallest width in which columns need no more lines than in the full width, pixels. */
        private int balancedWidth(List<Integer> columns) {
            int least = columns.stream().mapToInt(columnWidths::get).max().orElse(0);
            int allowed = countLines(columns, width);
            int balanced = least;
            while (balanced < width && countLines(columns, balanced) > allowed) {
                balanced++;
            }
            return balanced;
        }

        private int countLines(List<Integer> columns, int limit) {
            int lines = 1;
            int filled = 0;
            for (int column : columns) {
                if (filled > 0 && filled + columnWidths.get(column) > limit) {
                    lines++;
                    filled = 0;
                }
                filled += columnWidths.get(column);
            }
            return lines;
        }

        private void startLine() {
            if (end > 0) {
                line++;
                end = 0;
            }
        }

        /** Gives the labels at the start of lines the width of the longest, if their fields then fit. */
        private void alignFields(List<List<Integer>> units) {
            List<List<Integer>> starting = units.stream()
                    .filter(unit -> unit.size() > 1
                            && leftOfColumn.get(unit.get(0)) == 0
                            && lineOfColumn.get(unit.get(0)).equals(lineOfColumn.get(unit.get(1))))
                    .toList();
            int longest = starting.stream()
                    .mapToInt(unit -> columnWidths.get(unit.get(0)))
                    .max()
                    .orElse(0);
            for (List<Integer> unit : starting) {
                int shift = longest - columnWidths.get(unit.get(0));
                if (sumWidths(unit) + shift <= width) {
                    unit.subList(1, unit.size()).forEach(column -> leftOfColumn.merge(column, shift, Integer::sum));
                }
            }
        }

        /** Returns the components of each line. */
        List<List<PlacedCell>> placed() {
            List<List<PlacedCell>> lines = new ArrayList<>();
            GridCell before = null;
            for (GridCell cell : cells) {
                boolean sameRow = before != null && before.at.gridy == cell.at.gridy;
                List<PlacedCell> current = sameRow ? lines.get(lines.size() - 1) : List.of();
                int column = Math.max(leftOfColumn.get(cell.column()), endOf(current));
                if (sameRow
                        && lineOfColumn.get(cell.column()).equals(lineOfColumn.get(before.column()))
                        && fits(cell, column)) {
                    current.add(place(cell, column));
                } else if (sameRow && cell.isUnit() && !before.isUnit() && fits(cell, endOf(current))) {
                    current.add(place(cell, endOf(current)));
                } else {
                    column = leftOfColumn.get(cell.column());
                    lines.add(new ArrayList<>(List.of(place(cell, fits(cell, column) ? column : 0))));
                }
                before = cell;
            }
            return lines;
        }

        private static int endOf(List<PlacedCell> line) {
            return line.isEmpty() ? 0 : line.get(line.size() - 1).end();
        }

        private boolean fits(GridCell cell, int left) {
            int wanted = Math.min(cell.part.getPreferredSize().width, width);
            return left == 0 || left + cell.at.insets.left + wanted <= width;
        }

        private PlacedCell place(GridCell cell, int left) {
            int x = left == 0 ? 0 : left + cell.at.insets.left;
            int room = width - x - cell.at.insets.right;
            int preferred = cell.part.getPreferredSize().width;
            return new PlacedCell(cell, x, cell.fills() && cell.spans() ? room : Math.min(preferred, room));
        }
    }
}
