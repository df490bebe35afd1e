package faultline.studies;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/** A checked-in table, row by row. */
record ResultsTable(List<Map<String, String>> rows) {

    static ResultsTable of(String name) {
        try {
            List<String> lines = Files.readAllLines(Path.of("docs/results", name + ".csv"));
            String[] columns = lines.get(0).split(",");
            return new ResultsTable(lines.stream()
                    .skip(1)
                    .map(line -> row(columns, line.split(",", -1)))
                    .toList());
        } catch (IOException unread) {
            throw new UncheckedIOException(unread);
        }
    }

    private static Map<String, String> row(String[] columns, String[] cells) {
        Map<String, String> row = new LinkedHashMap<>();
        for (int i = 0; i < columns.length; i++) {
            row.put(columns[i], cells[i]);
        }
        return row;
    }

    ResultsTable where(String column, Predicate<String> wanted) {
        return new ResultsTable(
                rows.stream().filter(row -> wanted.test(row.get(column))).toList());
    }

    ResultsTable where(String column, String value) {
        return where(column, value::equals);
    }

    ResultsTable between(String column, double least, double most) {
        return where(column, cell -> Double.parseDouble(cell) >= least && Double.parseDouble(cell) <= most);
    }

    DoubleStream numbers(String column) {
        return cells(column).mapToDouble(Double::parseDouble).filter(Double::isFinite);
    }

    Stream<String> cells(String column) {
        return rows.stream().map(row -> row.get(column));
    }

    /** The only row's number. */
    double number(String column) {
        if (rows.size() != 1) {
            throw new AssertionError(rows.size() + " rows, not one");
        }
        return Double.parseDouble(rows.get(0).get(column));
    }
}
