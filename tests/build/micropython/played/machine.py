# What an example needs of a board.
def Pin(number):
    return number


def I2C(bus, **pins):
    return bus
