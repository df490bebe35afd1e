package faultline.campaign.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The tables of decisions 0043, 0052 and 0053, made of the csv files in docs/results/decisions; {@link #main} puts them
 * into the texts. The files in the folder {@code before} have the same cells of an earlier version.
 */
final class DecisionTables {

    /** The decisions that have tables, by their files. */
    static final List<String> PAGES =
            List.of("0043-one-odometer.md", "0052-steps-away-from-a-wall.md", "0053-near-walls.md");

    private static final String BEGIN =
            "<!-- The tables down to the next comment are made by src/conf/decision-figures. -->\n";
    private static final String END = "<!-- The end of the tables. -->\n";

    private final List<Map<String, String>> now;
    private final List<Map<String, String>> before;

    private DecisionTables(Path folder, String plan) throws IOException {
        now = allRungs(folder, plan);
        before = allRungs(folder.resolve("before"), plan);
    }

    private static List<Map<String, String>> allRungs(Path folder, String plan) throws IOException {
        return SurvivalTables.read(folder, plan).stream()
                .filter(row -> row.get("final_rung").equals("all"))
                .toList();
    }

    /** Replaces the tables in the decisions, given the folder of the documentation. */
    public static void main(String[] arguments) throws IOException {
        Path docs = Path.of(arguments[0]);
        for (String name : PAGES) {
            Path page = docs.resolve("decisions").resolve(name);
            String text = Files.readString(page);
            String start = text.substring(0, text.indexOf(BEGIN) + BEGIN.length());
            String end = text.substring(text.indexOf(END));
            Files.writeString(page, start + markdown(docs, name) + end);
        }
    }

    /** Returns the part of a page that is made of the tables. */
    static String block(String text) {
        int begin = text.indexOf(BEGIN) + BEGIN.length();
        return text.substring(begin, text.indexOf(END, begin));
    }

    /** Returns that part, made of the files of the documentation. */
    static String markdown(Path docs, String page) throws IOException {
        Path folder = docs.resolve("results/decisions");
        if (page.startsWith("0043")) {
            return "\n" + new DecisionTables(folder, "replaced-follower").alarms() + "\n";
        }
        if (page.startsWith("0053")) {
            return "\n" + new DecisionTables(folder, "near-walls").nearWalls() + "\n";
        }
        DecisionTables rooms = new DecisionTables(folder, "wanted-distance");
        DecisionTables empty = new DecisionTables(folder, "wanted-distance-empty");
        DecisionTables robots = new DecisionTables(folder, "room-to-turn");
        return "\n" + rooms.distances() + "\n" + empty.distances() + "\n" + robots.contacts() + "\n";
    }

    private String alarms() {
        StringBuilder out = new StringBuilder(
                "| time constant of the motors, s | change | now | before |\n" + "|---|---|---|---|\n");
        for (Map<String, String> row : now) {
            String constant = row.get("motor_time_constant_s");
            Map<String, String> earlier =
                    find(before, Map.of("motor_time_constant_s", constant, "change", row.get("change")));
            addRow(out, List.of(constant, row.get("change"), alarms(row), alarms(earlier)));
        }
        return out.toString();
    }

    private static String alarms(Map<String, String> row) {
        return share(row, "false_alarm_runs", count(row, "runs") - count(row, "broken"));
    }

    /** Returns how many runs carry on at each wanted distance, and how the others end. */
    private String distances() {
        boolean healthy = now.stream().anyMatch(row -> row.get("fault_kind").equals("none"));
        StringBuilder out =
                new StringBuilder("| wanted, m | `left` dies: carried on | before | contacts, stopped, lost |"
                        + " before |" + (healthy ? " healthy: carried on | contacts, stopped, lost |" : "") + "\n");
        out.append("|---".repeat(healthy ? 7 : 5)).append("|\n");
        for (String distance : levels("controller_distance_m")) {
            Map<String, String> fails = Map.of("controller_distance_m", distance, "fault_kind", "off");
            Map<String, String> row = find(now, fails);
            Map<String, String> earlier = find(before, fails);
            List<String> cells = new ArrayList<>(
                    List.of(distance, carriedOn(row), carriedOn(earlier), otherEnds(row), otherEnds(earlier)));
            if (healthy) {
                Map<String, String> none = find(now, Map.of("controller_distance_m", distance, "fault_kind", "none"));
                cells.addAll(List.of(carriedOn(none), otherEnds(none)));
            }
            addRow(out, cells);
        }
        return out.toString();
    }

    private static String otherEnds(Map<String, String> row) {
        return String.join(", ", row.get("collided"), row.get("stopped"), row.get("lost"));
    }

    private static String carriedOn(Map<String, String> row) {
        return share(row, "carried_on", count(row, "runs") - count(row, "broken") - count(row, "undecided"));
    }

    private String contacts() {
        StringBuilder out = new StringBuilder("| robot | `left` dies: contacts | before | `front` dies: contacts |"
                + " before | healthy: contacts | before |\n|---|---|---|---|---|---|---|\n");
        for (String robot : levels("robot")) {
            Map<String, String> left = Map.of("robot", robot, "fault_kind", "off", "fault_sensor", "left");
            Map<String, String> front = Map.of("robot", robot, "fault_kind", "off", "fault_sensor", "front");
            Map<String, String> none = Map.of("robot", robot, "fault_kind", "none");
            List<String> cells = new ArrayList<>(List.of(robot));
            for (Map<String, String> fault : List.of(left, front, none)) {
                cells.addAll(List.of(contacts(find(now, fault)), contacts(find(before, fault))));
            }
            addRow(out, cells);
        }
        return out.toString();
    }

    private String nearWalls() {
        StringBuilder out = new StringBuilder("| wanted, m | healthy: carried on | before | `left` dies: contacts |"
                + " before | `front` dies: contacts | before | `front-left` dies: contacts | before |\n"
                + "|---|---|---|---|---|---|---|---|---|\n");
        for (String distance : levels("controller_distance_m")) {
            Map<String, String> none = Map.of("controller_distance_m", distance, "fault_kind", "none");
            List<String> cells =
                    new ArrayList<>(List.of(distance, carriedOn(find(now, none)), carriedOn(find(before, none))));
            for (String sensor : List.of("left", "front", "front-left")) {
                Map<String, String> fails =
                        Map.of("controller_distance_m", distance, "fault_kind", "off", "fault_sensor", sensor);
                cells.addAll(List.of(contacts(find(now, fails)), contacts(find(before, fails))));
            }
            addRow(out, cells);
        }
        return out.toString();
    }

    private static String contacts(Map<String, String> row) {
        return share(row, "collided", count(row, "runs") - count(row, "broken"));
    }

    private Set<String> levels(String column) {
        return now.stream().map(row -> row.get(column)).collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private static Map<String, String> find(List<Map<String, String>> rows, Map<String, String> cells) {
        return rows.stream()
                .filter(row -> row.entrySet().containsAll(cells.entrySet()))
                .findFirst()
                .orElseThrow();
    }

    /** Returns a number of runs with the interval of its share. All runs of a cell are in different rooms. */
    private static String share(Map<String, String> row, String column, int n) {
        int successes = count(row, column);
        Interval interval = Interval.wilson(successes, n);
        return successes + " of " + n + " (" + Survival.percentText(interval.low()) + " to "
                + Survival.percentText(interval.high()) + " %)";
    }

    private static int count(Map<String, String> row, String column) {
        return Integer.parseInt(row.get(column));
    }

    private static void addRow(StringBuilder out, List<String> cells) {
        out.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }
}
