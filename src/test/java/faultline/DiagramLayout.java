package faultline;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * Places packages in rows, each above all packages that it uses. Only dependencies that do not follow from others have
 * a line. A line that passes a row has a bend there, so that it does not cross a box.
 */
final class DiagramLayout {

    private static final int SWEEPS = 24;
    private static final int BEND_WIDTH = 10;
    private static final int GAP = 12;

    /** A package or a bend of a line, in a row. */
    static final class Node {

        private final String name;
        private final int row;
        private final List<Node> above = new ArrayList<>();
        private final List<Node> below = new ArrayList<>();
        private double x;

        private Node(String name, int row) {
            this.name = name;
            this.row = row;
        }

        String name() {
            return name;
        }

        int row() {
            return row;
        }

        boolean isBend() {
            return name.isEmpty();
        }

        int width() {
            return isBend() ? BEND_WIDTH : 36 + 7 * name.length();
        }

        /** Returns the middle. */
        double x() {
            return x;
        }
    }

    private final Map<String, Set<String>> uses;
    private final Map<String, Node> nodes = new HashMap<>();
    private final List<List<Node>> rows = new ArrayList<>();
    private final List<List<Node>> edges = new ArrayList<>();
    private final int width;

    /**
     * Makes a layout.
     *
     * @param uses what each package uses, without cycles
     * @param order all packages, lowest first
     * @param width of the picture
     */
    DiagramLayout(Map<String, Set<String>> uses, List<String> order, int width) {
        this.uses = uses;
        this.width = width;
        Map<String, Integer> levels = levels(order);
        int top = Collections.max(levels.values());
        for (int row = 0; row <= top; row++) {
            rows.add(new ArrayList<>());
        }
        for (String name : order) {
            Node node = new Node(name, top - levels.get(name));
            nodes.put(name, node);
            rows.get(node.row).add(node);
        }
        for (String user : order) {
            directlyUsed(user).forEach(used -> connect(nodes.get(user), nodes.get(used)));
        }
        rows.forEach(this::pack);
        for (int i = 0; i < SWEEPS; i++) {
            sweep(i % 2 == 0);
        }
    }

    /** Returns the nodes of each row from left to right, the top row first. */
    List<List<Node>> rows() {
        return rows;
    }

    /** Returns the lines, each from the package that uses to the package that is used. */
    List<List<Node>> edges() {
        return edges;
    }

    private Map<String, Integer> levels(List<String> order) {
        Map<String, Integer> levels = new HashMap<>();
        for (String name : order) {
            levels.put(
                    name,
                    uses.getOrDefault(name, Set.of()).stream()
                            .mapToInt(used -> levels.get(used) + 1)
                            .max()
                            .orElse(0));
        }
        return levels;
    }

    private Set<String> directlyUsed(String user) {
        Set<String> direct = new TreeSet<>(uses.getOrDefault(user, Set.of()));
        for (String used : uses.getOrDefault(user, Set.of())) {
            direct.removeAll(reachable(used));
        }
        return direct;
    }

    private Set<String> reachable(String user) {
        Set<String> found = new TreeSet<>();
        for (String used : uses.getOrDefault(user, Set.of())) {
            found.add(used);
            found.addAll(reachable(used));
        }
        return found;
    }

    private void connect(Node user, Node used) {
        List<Node> edge = new ArrayList<>(List.of(user));
        Node last = user;
        for (int row = user.row + 1; row <= used.row; row++) {
            Node next = used;
            if (row < used.row) {
                next = new Node("", row);
                rows.get(row).add(next);
            }
            last.below.add(next);
            next.above.add(last);
            edge.add(next);
            last = next;
        }
        edges.add(edge);
    }

    /** Orders each row by the mean place of the neighbours in the row before. */
    private void sweep(boolean down) {
        List<List<Node>> visited = new ArrayList<>(rows);
        if (!down) {
            Collections.reverse(visited);
        }
        for (List<Node> row : visited) {
            Map<Node, Double> means = new HashMap<>();
            for (Node node : row) {
                List<Node> neighbours = down ? node.above : node.below;
                means.put(
                        node, neighbours.stream().mapToDouble(Node::x).average().orElse(node.x));
            }
            row.sort(Comparator.comparing(means::get));
            row.forEach(node -> node.x = means.get(node));
            separate(row);
        }
    }

    private void pack(List<Node> row) {
        row.forEach(node -> node.x = width / 2.0);
        separate(row);
    }

    /** Moves the nodes of a row apart, keeping their order and, as far as possible, their place. */
    private void separate(List<Node> row) {
        double[] wanted = row.stream().mapToDouble(Node::x).toArray();
        double right = 0;
        for (Node node : row) {
            node.x = Math.max(node.x, right + GAP + node.width() / 2.0);
            right = node.x + node.width() / 2.0;
        }
        double left = width;
        for (int i = row.size() - 1; i >= 0; i--) {
            Node node = row.get(i);
            double middle = (node.x + Math.min(wanted[i], node.x)) / 2;
            node.x = Math.min(Math.max(middle, leftmost(row, i)), left - GAP - node.width() / 2.0);
            left = node.x - node.width() / 2.0;
        }
    }

    private static double leftmost(List<Node> row, int index) {
        double x = row.get(index).width() / 2.0 + GAP;
        for (int i = 0; i < index; i++) {
            x += row.get(i).width() + GAP;
        }
        return x;
    }
}
