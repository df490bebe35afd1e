package faultline.external;

import faultline.io.DecimalText;
import faultline.io.JsonException;
import faultline.io.JsonParser;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.xml.Allowed;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** The members of a received message, checked when they are read. Unknown members are ignored. */
final class MessageReader {

    /** From here on a double cannot hold every whole number. */
    private static final double FIRST_ROUNDED = 1L << 53;

    private static final Message WHOLE_NUMBERS = ControllerProblem.WHOLE_FROM.with(Long.MIN_VALUE, Long.MAX_VALUE);

    private final Map<?, ?> members;

    private MessageReader(Map<?, ?> members) {
        this.members = members;
    }

    /**
     * {@return the members of a line with one JSON object}
     *
     * @param line one JSON object
     * @throws ProtocolException if the line is not a JSON object
     */
    static MessageReader of(String line) throws ProtocolException {
        Object value;
        try {
            value = JsonParser.parse(line);
        } catch (JsonException e) {
            throw new ProtocolException(ControllerProblem.NO_JSON, MessageText.quoted(line), e.getMessage());
        }
        if (!(value instanceof Map<?, ?> map)) {
            throw new ProtocolException(ControllerProblem.NO_OBJECT, MessageText.quoted(line));
        }
        return new MessageReader(map);
    }

    /** Returns whether there is a member; one that is null counts as missing. */
    boolean has(String name) {
        Object member = members.get(name);
        return member != null && member != JsonParser.NULL;
    }

    /** Returns a string member. */
    String string(String name) throws ProtocolException {
        if (members.get(name) instanceof String string) {
            return string;
        }
        throw wrong(name, ControllerProblem.STRING.with());
    }

    /** Returns a string member, or another string if there is none. */
    String string(String name, String defaultValue) throws ProtocolException {
        return has(name) ? string(name) : defaultValue;
    }

    /** Returns a finite number. */
    double number(String name) throws ProtocolException {
        if (members.get(name) instanceof Number number && Double.isFinite(number.doubleValue())) {
            return number.doubleValue();
        }
        throw wrong(name, ControllerProblem.NUMBER.with());
    }

    /** Returns a whole number, exactly as it was written. */
    long whole(String name) throws ProtocolException {
        if (members.get(name) instanceof Long number) {
            return number;
        }
        if (members.get(name) instanceof Double number
                && number == Math.rint(number)
                && Math.abs(number) < FIRST_ROUNDED) {
            return number.longValue();
        }
        boolean tooLarge =
                members.get(name) instanceof Number number && number.doubleValue() == Math.rint(number.doubleValue());
        throw wrong(name, tooLarge ? WHOLE_NUMBERS : ControllerProblem.WHOLE.with());
    }

    /** Returns a whole number within limits, both of which are included and less than 2^53. */
    long whole(String name, long min, long max) throws ProtocolException {
        if (members.get(name) instanceof Number number
                && number.doubleValue() == Math.rint(number.doubleValue())
                && number.doubleValue() >= min
                && number.doubleValue() <= max) {
            return number.longValue();
        }
        throw wrong(name, Allowed.WHOLE_NUMBER.with(Allowed.CLOSED.with(min, max)));
    }

    /** Returns a truth value, or another if there is none. */
    boolean flag(String name, boolean defaultValue) throws ProtocolException {
        if (!has(name)) {
            return defaultValue;
        }
        if (members.get(name) instanceof Boolean flag) {
            return flag;
        }
        throw wrong(name, Allowed.FLAG.with());
    }

    /** Returns an object member. */
    MessageReader object(String name) throws ProtocolException {
        if (members.get(name) instanceof Map<?, ?> map) {
            return new MessageReader(map);
        }
        throw wrong(name, ControllerProblem.OBJECT.with());
    }

    /** Returns an array of objects. */
    List<MessageReader> objects(String name) throws ProtocolException {
        if (!(members.get(name) instanceof List<?> list)) {
            throw wrong(name, ControllerProblem.OBJECTS.with());
        }
        List<MessageReader> objects = new ArrayList<>();
        for (Object value : list) {
            if (!(value instanceof Map<?, ?> map)) {
                throw wrong(name, ControllerProblem.OBJECTS.with());
            }
            objects.add(new MessageReader(map));
        }
        return objects;
    }

    /** Returns an array of finite numbers in which {@code null} represents a given value. */
    double[] numbers(String name, double nullValue) throws ProtocolException {
        if (!(members.get(name) instanceof List<?> list)) {
            throw wrong(name, ControllerProblem.NUMBERS.with());
        }
        double[] numbers = new double[list.size()];
        for (int i = 0; i < numbers.length; i++) {
            Object value = list.get(i);
            numbers[i] = value instanceof Number number ? number.doubleValue() : nullValue;
            if (value != JsonParser.NULL && !(value instanceof Number && Double.isFinite(numbers[i]))) {
                throw wrong(name, ControllerProblem.NUMBERS.with());
            }
        }
        return numbers;
    }

    /** Returns an array of truth values. */
    boolean[] flags(String name) throws ProtocolException {
        if (!(members.get(name) instanceof List<?> list) || !list.stream().allMatch(Boolean.class::isInstance)) {
            throw wrong(name, ControllerProblem.FLAGS.with());
        }
        boolean[] flags = new boolean[list.size()];
        for (int i = 0; i < flags.length; i++) {
            flags[i] = (Boolean) list.get(i);
        }
        return flags;
    }

    /** Returns a value as JSON, without blanks. */
    private static String textOf(Object value) {
        if (value instanceof List<?> list) {
            return list.stream().map(MessageReader::textOf).collect(Collectors.joining(",", "[", "]"));
        }
        if (value instanceof Map<?, ?> map) {
            return map.entrySet().stream()
                    .map(member -> textOf(member.getKey()) + ":" + textOf(member.getValue()))
                    .collect(Collectors.joining(",", "{", "}"));
        }
        if (value instanceof String string) {
            return '"' + string + '"';
        }
        return value instanceof Double number ? DecimalText.format(number) : String.valueOf(value);
    }

    private ProtocolException wrong(String name, Message allowed) {
        return new ProtocolException(ControllerProblem.MEMBER, MessageText.quoted(name), given(name), allowed);
    }

    private Object given(String name) {
        Object value = members.get(name);
        if (value == null) {
            return ControllerProblem.MISSING.with();
        }
        if (value instanceof String string) {
            return ControllerProblem.GIVEN_STRING.with(MessageText.quoted(string));
        }
        String json = MessageText.excerpt(textOf(value));
        if (value instanceof Number) {
            return ControllerProblem.GIVEN_NUMBER.with(json);
        }
        if (value instanceof List) {
            return ControllerProblem.GIVEN_ARRAY.with(json);
        }
        return value instanceof Map ? ControllerProblem.GIVEN_OBJECT.with(json) : json;
    }
}
