package faultline.io;

/** A number in JSON that is beyond all doubles, or has more digits than a long. Messages repeat its text. */
final class HugeNumber extends Number {

    private static final long serialVersionUID = 1L;

    private final String text;

    HugeNumber(String text) {
        this.text = text;
    }

    @Override
    public double doubleValue() {
        return Double.parseDouble(text);
    }

    @Override
    public float floatValue() {
        return (float) doubleValue();
    }

    @Override
    public long longValue() {
        return (long) doubleValue();
    }

    @Override
    public int intValue() {
        return (int) doubleValue();
    }

    @Override
    public String toString() {
        return text;
    }
}
