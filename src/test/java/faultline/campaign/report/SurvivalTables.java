package faultline.campaign.report;

import faultline.campaign.run.Csv;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/** The survival tables of docs/results.md, made of the csv files beside it; {@link #main} puts them into the text. */
final class SurvivalTables {

    private static final String BEGIN = "<!-- The tables down to the next comment are made by src/conf/survival. -->\n";
    private static final String END = "<!-- The end of the tables. -->\n";
    private static final List<String> RUNGS = List.of("ALL", "REDUCED", "THREE", "TWO", "ONE", "STOP");

    private final Path folder;

    private SurvivalTables(Path folder) {
        this.folder = folder;
    }

    /** Replaces the tables in a page, given its path. */
    public static void main(String[] arguments) throws IOException {
        Path page = Path.of(arguments[0]);
        String text = Files.readString(page);
        String before = text.substring(0, text.indexOf(BEGIN) + BEGIN.length());
        String after = text.substring(text.indexOf(END));
        Files.writeString(page, before + markdown(page.resolveSibling("results/survival")) + after);
    }

    /** Returns the part of a page that is made of the tables. */
    static String block(String text) {
        int begin = text.indexOf(BEGIN) + BEGIN.length();
        return text.substring(begin, text.indexOf(END, begin));
    }

    static String markdown(Path folder) throws IOException {
        return new SurvivalTables(folder).markdown();
    }

    private String markdown() throws IOException {
        StringBuilder out = new StringBuilder();
        String runs = read("survival").stream()
                .filter(row -> row.get("fault_label").equals("off"))
                .findFirst()
                .orElseThrow()
                .get("runs");
        out.append("\nWith diagnosis, ").append(runs).append(" runs in each cell:\n\n");
        out.append(matrix("on"));
        out.append("\nWithout diagnosis, the same rooms and faults:\n\n").append(matrix("off"));
        out.append("\nWith diagnosis and one failing sensor, by the rung that controlled the robot at the end:\n\n")
                .append(rungs());
        out.append("\nOther cases, all with diagnosis unless they say otherwise:\n\n")
                .append(cases());
        out.append("\nDetection with diagnosis, medians of the runs in which the fault is detected, with their")
                .append(" number in brackets. For sudden faults: seconds until the sensor is distrusted, counting only")
                .append(" the time during which a surface is within its range. For drifts: the largest error of a")
                .append(" reading until then, in millimetres.\n\n")
                .append(detection());
        return out.append('\n').toString();
    }

    private List<Map<String, String>> read(String name) throws IOException {
        return read(folder, name);
    }

    /** Returns the rows of a csv file in a folder, by column. */
    static List<Map<String, String>> read(Path folder, String name) throws IOException {
        List<String> lines = Files.readAllLines(folder.resolve(name + ".csv"));
        List<String> header = Csv.cells(lines.get(0));
        List<Map<String, String>> rows = new ArrayList<>();
        for (String line : lines.subList(1, lines.size())) {
            List<String> cells = Csv.cells(line);
            Map<String, String> row = new LinkedHashMap<>();
            for (int i = 0; i < cells.size(); i++) {
                row.put(header.get(i), cells.get(i));
            }
            rows.add(row);
        }
        return rows;
    }

    private String matrix(String diagnosis) throws IOException {
        Map<String, Map<String, Map<String, String>>> cells = bySensor(read("survival").stream()
                .filter(row -> !row.get("fault_label").equals("none"))
                .filter(row -> row.get("controller_diagnosis").equals(diagnosis)));
        Map<String, Map<String, String>> all = cells.remove("all");
        Map<String, String> total = all.remove("all");
        StringBuilder out = header(all.keySet(), " | all");
        cells.forEach((label, row) -> {
            out.append("| ").append(label);
            all.keySet().forEach(sensor -> out.append(" | ").append(share(row.get(sensor))));
            out.append(" | ").append(share(row.get("all"))).append(" |\n");
        });
        out.append("| all");
        all.values().forEach(row -> out.append(" | ").append(share(row)));
        return out.append(" | ").append(share(total)).append(" |\n").toString();
    }

    private String detection() throws IOException {
        Map<String, Map<String, Map<String, String>>> cells = bySensor(read("detection").stream()
                .filter(row -> !row.get("fault_label").equals("all"))
                .filter(row -> !row.get("fault_sensor").equals("all")));
        Set<String> sensors = cells.values().iterator().next().keySet();
        StringBuilder out = header(sensors, "");
        cells.forEach((label, row) -> {
            out.append("| ").append(label).append(label.startsWith("drift") ? ", mm" : ", s");
            sensors.forEach(sensor -> out.append(" | ").append(detection(row.get(sensor))));
            out.append(" |\n");
        });
        return out.toString();
    }

    /** Returns the rows of all rungs together, by fault and sensor. */
    private static Map<String, Map<String, Map<String, String>>> bySensor(Stream<Map<String, String>> rows) {
        Map<String, Map<String, Map<String, String>>> cells = new LinkedHashMap<>();
        rows.filter(row -> row.get("final_rung").equals("all"))
                .forEach(row -> cells.computeIfAbsent(row.get("fault_label"), label -> new LinkedHashMap<>())
                        .put(row.get("fault_sensor"), row));
        return cells;
    }

    private static StringBuilder header(Set<String> sensors, String last) {
        int columns = sensors.size() + (last.isEmpty() ? 1 : 2);
        return new StringBuilder("| fault | " + String.join(" | ", sensors) + last + " |\n|" + "---|".repeat(columns))
                .append('\n');
    }

    private static String detection(Map<String, String> row) {
        boolean drift = row.get("fault_label").startsWith("drift");
        String median = row.get(drift ? "error_median_m" : "view_median_s");
        String value = median.isEmpty() ? "\u2013" : median(Double.parseDouble(median), drift);
        return value + " (" + row.get("detected") + " of " + row.get("runs") + ")";
    }

    private static String median(double value, boolean drift) {
        return String.format(Locale.ROOT, drift ? "%.0f" : "%.2f", drift ? 1000 * value : value);
    }

    private static String share(Map<String, String> row) {
        return String.format(
                Locale.ROOT,
                "%s (%s to %s)",
                percent(row.get("share")),
                percent(row.get("share_low")),
                percent(row.get("share_high")));
    }

    /** Uses one decimal above 99 %, or two, so that less than 100 % is not rounded to 100 %. */
    private static String percent(String share) {
        double value = 100 * Double.parseDouble(share);
        int decimals = value <= 99 || value == 100 ? 0 : value < 99.95 ? 1 : 2;
        return String.format(Locale.ROOT, "%." + decimals + "f", value);
    }

    private String rungs() throws IOException {
        StringBuilder out =
                new StringBuilder("| rung | runs | carried on, % | contacts | lost |\n|---|---|---|---|---|\n");
        List<Map<String, String>> rows = read("survival");
        for (String rung : RUNGS) {
            rows.stream()
                    .filter(row -> row.get("final_rung").equals(rung)
                            && row.get("fault_label").equals("all")
                            && row.get("controller_diagnosis").equals("on"))
                    .forEach(row -> out.append("| `")
                            .append(rung)
                            .append("` | ")
                            .append(String.join(
                                    " | ", row.get("runs"), share(row), row.get("collided"), row.get("lost")))
                            .append(" |\n"));
        }
        return out.toString();
    }

    private String cases() throws IOException {
        StringBuilder out = new StringBuilder(
                "| case | runs | carried on, % | contacts | stopped | lost | runs with a false alarm |\n"
                        + "|---|---|---|---|---|---|---|\n");
        for (Map<String, String> row : read("healthy")) {
            addCase(out, row, row.get("noise").equals("none") ? "healthy" : "healthy, noise of " + row.get("noise"));
        }
        for (Map<String, String> row : read("survival")) {
            String with = row.get("controller_diagnosis").equals("on") ? "" : ", without diagnosis";
            if (row.get("fault_label").equals("all") && row.get("fault_sensor").equals("all")) {
                addCase(out, row, "one sensor fails" + with);
            }
        }
        for (Map<String, String> row : read("two-faults")) {
            if (row.get("fault_label").equals("all")) {
                addCase(out, row, "two faults");
            }
        }
        addCasesOfWheels(out);
        for (Map<String, String> row : read("wall-side-sensors")) {
            addCase(out, row, "on the wall's side on: " + row.get("sensors_on") + "; the others at random");
        }
        for (Map<String, String> row : read("one-sensor")) {
            addCase(out, row, row.get("sensors_on") + " alone");
        }
        return out.toString();
    }

    private void addCasesOfWheels(StringBuilder out) throws IOException {
        for (Map<String, String> row : read("wrong-wheels")) {
            if (row.get("fault_label").equals("none")) {
                addCase(out, row, "wheels and track off by up to 5 %");
            } else if (row.get("fault_label").equals("all")) {
                String sensor = row.get("fault_sensor").replace("all", "left or front");
                addCase(out, row, "wheels and track off by up to 5 %, " + sensor + " fails");
            }
        }
        for (Map<String, String> row : read("motor-faults")) {
            boolean each = row.get("fault_sensor").equals("all")
                    && !row.get("fault_label").equals("all");
            if (each && row.get("controller_diagnosis").equals("on")) {
                addCase(out, row, "motors of one side: " + row.get("fault_label"));
            }
        }
    }

    private static void addCase(StringBuilder out, Map<String, String> row, String name) {
        if (row.get("final_rung").equals("all")) {
            out.append("| ")
                    .append(String.join(
                            " | ",
                            name,
                            row.get("runs"),
                            share(row),
                            row.get("collided"),
                            row.get("stopped"),
                            row.get("lost"),
                            row.get("false_alarm_runs")))
                    .append(" |\n");
        }
    }
}
